#pragma once
#include "frame/image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

/// Returns a picture of a striped flag in front of a sky, for reports without a renderer. `phase`: phase of
/// the flag's wave.
inline simreel::frame::Image picture(int width, int height, double phase) {
  simreel::frame::Image image{width, height, {}};
  image.bytes.reserve(std::size_t(width) * std::size_t(height) * 4);
  const auto put = [&](double r, double g, double b) {
    for (const double value : {r, g, b, 255.0})
      image.bytes.push_back(std::uint8_t(std::clamp(value, 0.0, 255.0)));
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = double(x) / width, v = double(y) / height;
      const double wave = std::sin(9 * u - phase) * 0.05 * u;
      const double inFlag = (v - wave - 0.2) / 0.5;
      const double light = 0.75 + 0.25 * std::cos(9 * u - phase);
      if (u > 0.2 && u < 0.85 && inFlag > 0 && inFlag < 1) {
        const bool red = int(inFlag * 6) % 2 == 0;
        put(light * (red ? 190 : 235), light * (red ? 40 : 230), light * (red ? 45 : 220));
      } else if (u > 0.185 && u < 0.2 && v > 0.12 && v < 0.9) {
        put(60, 62, 66);
      } else if (v > 0.88) {
        put(92, 88, 62);
      } else {
        put(90 + 130 * v, 140 + 60 * v, 205 - 20 * v);
      }
    }
  return image;
}

inline int pixelDifference(const simreel::frame::Image& a, const simreel::frame::Image& b, int x, int y) {
  const auto at = (std::size_t(y) * std::size_t(a.width) + std::size_t(x)) * 4;
  int max = 0;
  for (std::size_t c = 0; c < 3; ++c) max = std::max(max, std::abs(a.bytes[at + c] - b.bytes[at + c]));
  return max;
}

/// Returns the difference of two pictures. It is dark where they are equal, and yellow to red where they
/// differ.
inline simreel::frame::Image difference(const simreel::frame::Image& a, const simreel::frame::Image& b) {
  simreel::frame::Image image = a;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const int much = pixelDifference(a, b, x, y);
      std::uint8_t* const to = &image.bytes[(std::size_t(y) * std::size_t(a.width) + std::size_t(x)) * 4];
      const auto dim = std::uint8_t((to[0] + to[1] + to[2]) / 12);
      const std::array<std::uint8_t, 3> heat = {255, std::uint8_t(std::max(0, 220 - much)), 20};
      for (std::size_t c = 0; c < 3; ++c) to[c] = much == 0 ? dim : heat[c];
    }
  return image;
}

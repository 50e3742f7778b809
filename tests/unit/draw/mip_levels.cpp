#include "draw/surface/mip_levels.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using draw::MipLevel;

namespace {

/// Returns noise. Alpha is 255 everywhere if `opaque` is true; otherwise it is often 0 or 255.
std::vector<std::uint8_t> noise(glm::ivec2 size, bool opaque) {
  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(size.x * size.y));
  std::uint32_t state = 12345;
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    state = state * 1664525U + 1013904223U;
    rgba[i] = static_cast<std::uint8_t>(state >> 24U);
    if (i % 4 != 3) continue;
    const std::uint32_t kind = state >> 20U & 3U;
    if (opaque || kind == 0) rgba[i] = 255;
    if (!opaque && kind == 1) rgba[i] = 0;
  }
  return rgba;
}

double decoded(double byte) {
  const double c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double encoded(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

/// A texel of an independent implementation of the filter, which uses overlaps of intervals in double
/// precision, with separate light and alpha.
struct Texel {
  double r = 0, g = 0, b = 0, alpha = 0;  // light is not premultiplied by alpha
};
struct Level {
  int width, height;
  std::vector<Texel> texels;
};

Level below(const Level& above) {
  Level made{std::max(above.width / 2, 1), std::max(above.height / 2, 1), {}};
  const auto overlap = [](int i, int count, int j, int from) {
    const double fraction = double(from) / count;
    return std::max(0.0, std::min((i + 1) * fraction, j + 1.0) - std::max(i * fraction, double(j)));
  };
  for (int y = 0; y < made.height; ++y)
    for (int x = 0; x < made.width; ++x) {
      Texel sum, plain;
      double area = 0;
      for (int v = std::max(2 * y - 1, 0); v < std::min(2 * y + 4, above.height); ++v)
        for (int u = std::max(2 * x - 1, 0); u < std::min(2 * x + 4, above.width); ++u) {
          const double w =
              overlap(x, made.width, u, above.width) * overlap(y, made.height, v, above.height);
          const Texel& t = above.texels[static_cast<std::size_t>(v * above.width + u)];
          area += w;
          sum.alpha += w * t.alpha;
          for (double Texel::*c : {&Texel::r, &Texel::g, &Texel::b}) {
            sum.*c += w * t.alpha * t.*c;
            plain.*c += w * t.*c;
          }
        }
      Texel mean;
      mean.alpha = sum.alpha / area;
      for (double Texel::*c : {&Texel::r, &Texel::g, &Texel::b})
        mean.*c = sum.alpha > 0 ? sum.*c / sum.alpha : plain.*c / area;
      made.texels.push_back(mean);
    }
  return made;
}

Level levelOf(glm::ivec2 size, std::span<const std::uint8_t> rgba) {
  Level level{size.x, size.y, {}};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    level.texels.push_back(
        {decoded(rgba[i]), decoded(rgba[i + 1]), decoded(rgba[i + 2]), rgba[i + 3] / 255.0});
  return level;
}

}  // namespace

TEST_CASE("mip levels: the conversion table equals the sRGB curve") {
  for (int i = 0; i < 256; ++i)
    CHECK(draw::linearOfSrgb(static_cast<std::uint8_t>(i)) == std::lround(65535 * decoded(i)));
}

TEST_CASE("mip levels agree with the same filter in double precision, also at odd sizes") {
  for (const glm::ivec2 size :
       {glm::ivec2(64, 64), {63, 63}, {65, 40}, {1, 37}, {100, 1}, {7, 5}, {2, 3}, {3, 129}, {127, 254}})
    for (const bool opaque : {true, false}) {
      CAPTURE(size.x);
      CAPTURE(size.y);
      CAPTURE(opaque);
      const auto rgba = noise(size, opaque);
      const auto levels = draw::mipLevels(size, rgba);
      Level twin = levelOf(size, rgba);
      double worst = 0, worstAlpha = 0;
      for (const MipLevel& level : levels) {
        twin = below(twin);
        REQUIRE(level.size == glm::ivec2(twin.width, twin.height));
        REQUIRE(level.rgba.size() == 4 * twin.texels.size());
        for (std::size_t i = 0; i < twin.texels.size(); ++i) {
          const Texel& t = twin.texels[i];
          const double wanted[] = {encoded(t.r), encoded(t.g), encoded(t.b)};
          // If alpha is nearly zero, colours are inaccurate, because weights are multiples of 1/65026.
          if (t.alpha > 0.02 || t.alpha == 0)
            for (std::size_t c = 0; c < 3; ++c)
              worst = std::max(worst, std::abs(level.rgba[4 * i + c] - wanted[c]));
          worstAlpha = std::max(worstAlpha, std::abs(level.rgba[4 * i + 3] - 255 * t.alpha));
        }
      }
      CHECK(levels.back().size == glm::ivec2(1, 1));
      CHECK(worst < (opaque ? 0.53 : 0.6));  // The tolerance covers rounding and the errors of the table
                                             // and the weights.
      CHECK(worstAlpha < 0.52);
    }
}

TEST_CASE("mip levels: a uniform colour stays uniform") {
  for (int byte = 0; byte < 256; ++byte)
    for (const int alpha : {0, 1, 128, 255}) {
      std::vector<std::uint8_t> rgba(4 * 5 * 6);
      for (std::size_t i = 0; i < rgba.size(); ++i)
        rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? alpha : byte);
      for (const MipLevel& level : draw::mipLevels({5, 6}, rgba))
        CHECK(std::equal(level.rgba.begin(), level.rgba.end(), rgba.begin()));
    }
}

TEST_CASE("mip levels: transparent texels do not bleed") {
  // An invisible green texel is next to an opaque red one.
  const std::vector<std::uint8_t> rgba = {255, 0, 0, 255, 0, 255, 0, 0};
  const auto level = draw::mipLevels({2, 1}, rgba).front();
  CHECK(level.rgba == std::vector<std::uint8_t>{255, 0, 0, 128});
}

TEST_CASE("mip levels: every machine computes the same bytes") {
  std::vector<std::uint8_t> all;
  for (const glm::ivec2 size : {glm::ivec2(64, 32), {61, 35}, {1, 9}})
    for (const bool opaque : {true, false})
      for (const MipLevel& level : draw::mipLevels(size, noise(size, opaque)))
        all.insert(all.end(), level.rgba.begin(), level.rgba.end());
  CHECK(hashHex(std::as_bytes(std::span(all))) == "fe4af06bf947cccb57bd143365c4e7bf");
}

#include "sim/spread/plan.hpp"

#include "base/error.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr int maxMapSide = 16384;
/// Tolerance, in steps, for rounding errors of frame times.
constexpr double hair = 1e-6;

double hashedFraction(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return shader::hash3(glm::uvec3(x, y, seed)).x / 4294967296.0;
}

/// Returns value noise at (x, y): hashes of the four surrounding lattice points, interpolated with the
/// weights 3u^2 - 2u^3.
double valueNoise(double x, double y, std::uint32_t seed) {
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto blend = [](double u) { return u * u * (3.0 - 2.0 * u); };
  const double u = blend(x - left);
  const double v = blend(y - top);
  const auto ix = static_cast<std::uint32_t>(left);
  const auto iy = static_cast<std::uint32_t>(top);
  const double a = hashedFraction(ix, iy, seed);
  const double b = hashedFraction(ix + 1, iy, seed);
  const double c = hashedFraction(ix, iy + 1, seed);
  const double d = hashedFraction(ix + 1, iy + 1, seed);
  const double above = a + u * (b - a);
  const double below = c + u * (d - c);
  return above + v * (below - above);
}

}  // namespace

void SpreadParameters::describeGrid(scene::Fields& f) {
  f.pair("size", size, {3, 65536}, "cells", "Width and height of the grid.");
  f.leftOut("size", "[640,360]; in version 2 as many cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.choice("border", border, {"torus", "closed"},
           "Cells of opposite borders are neighbours, or nothing lies beyond.");
  f.number("stepsPerSecond", stepsPerSecond, {1e-3, 1e6}, "1/s", "Steps in a second of scene time.");
}

void SpreadParameters::describeLook(scene::Fields& f) {
  f.boolean("chart", chart, "Draws the counts so far as curves over the picture.");
  f.number("chartSeconds", chartSeconds, {0, 1e6}, "s",
           "Length of the chart's time axis, which grows beyond that when needed.");
  f.idleUnless(chart, "chart", {"chartSeconds"}, "a \"chart\"");
  f.group("display", "Placement of the field over the picture.", [&](scene::Fields& d) {
    display.describe(d);
    for (const char* name : {"map", "stops", "low", "high"}) {
      d.leftOut(name, "by \"colors\"");
      if (d.given(name)) d.error(name, "its colours are in \"colors\", one for each state");
    }
  });
}

int Pace::stepsPerFrame() const {
  return std::max(1, static_cast<int>(std::ceil(stepsPerSecond * frameSeconds - hair)));
}

Pace::Steps Pace::during(double time) const {
  const auto frame = std::round(time / frameSeconds);
  const double perFrame = stepsPerSecond * frameSeconds;
  const double first = std::floor(frame * perFrame + hair);
  const double end = std::floor((frame + 1) * perFrame + hair);
  return {static_cast<int>(end - first), first / stepsPerSecond};
}

std::vector<double> smoothLevels(const std::filesystem::path& file, const char* what, glm::ivec2 grid) {
  const Levels picture = loadLevels(file, what, maxMapSide);
  std::vector<double> levels;
  levels.reserve(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x) {
      const double px = std::clamp((x + 0.5) * picture.size.x / grid.x - 0.5, 0.0, picture.size.x - 1.0);
      const double py = std::clamp((y + 0.5) * picture.size.y / grid.y - 0.5, 0.0, picture.size.y - 1.0);
      const int left = static_cast<int>(px);
      const int top = static_cast<int>(py);
      const int right = std::min(left + 1, picture.size.x - 1);
      const int bottom = std::min(top + 1, picture.size.y - 1);
      const double u = px - left;
      const double v = py - top;
      const double above = picture.at(left, top) * (1 - u) + picture.at(right, top) * u;
      const double below = picture.at(left, bottom) * (1 - u) + picture.at(right, bottom) * u;
      levels.push_back((above * (1 - v) + below * v) / picture.white);
    }
  return levels;
}

std::vector<double> hashNoise(glm::ivec2 grid, double cells, unsigned seed) {
  std::vector<double> noise;
  noise.reserve(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x) {
      double sum = 0;
      double weight = 0.5;
      double frequency = 1.0 / cells;
      for (unsigned octave = 0; octave < 4; ++octave, weight *= 0.5, frequency *= 2)
        sum += weight * valueNoise((x + 0.5) * frequency, (y + 0.5) * frequency, seed + octave);
      noise.push_back(sum / 0.9375);
    }
  return noise;
}

double cellFraction(std::size_t cell, unsigned seed) {
  return hashedFraction(static_cast<std::uint32_t>(cell), 0x9e3779b9U, seed);
}

std::uint32_t thresholdOf(double probability) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(probability, 0.0, 1.0) * shader::certain));
}

void appendGradient(std::vector<glm::vec3>& colors, const std::vector<glm::vec3>& stops, int count) {
  for (int i = 0; i < count; ++i) {
    const float place = count < 2 ? 0.0F
                                  : static_cast<float>(i) / static_cast<float>(count - 1) *
                                        static_cast<float>(stops.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), stops.size() - 1);
    const auto right = std::min(left + 1, stops.size() - 1);
    colors.push_back(glm::mix(stops[left], stops[right], place - static_cast<float>(left)));
  }
}

}  // namespace simreel::sim

// Tests line integral convolution of a fluid by comparison with its equation in double precision. Also
// tests the result of soft brushes.
#include "reference/fluid_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr int lineCells = 24, lineFine = 3;

/// Returns a fluid with the given `velocity` at the centres of its faces.
template <class Velocity>
FluidTwin movedBy(const Velocity& velocity) {
  sim::FluidParameters p;
  p.size = {lineCells, lineCells};
  p.strokes.clear();
  p.show = sim::FluidParameters::Show::lines;
  p.lineDetail = lineFine;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, 1.0 / 30));
  for (int y = -1; y <= lineCells; ++y)
    for (int x = -1; x <= lineCells; ++x)
      twin.flow[twin.index(x, y)] = {velocity(x, y + 0.5).x, velocity(x + 0.5, y).y, 0, 0};
  return twin;
}

double grainOf(glm::dvec2 p) {
  const auto at = [](double x) {
    return static_cast<unsigned>(static_cast<int>(std::floor(x * lineFine)));
  };
  return (shader::hash3({at(p.x), at(p.y), 17}).x >> 8U) / 16777216.0;
}

double weightOf(double along, double phase) {
  constexpr double pi = std::numbers::pi;
  return (1 + std::cos(pi * along)) * (1 + 0.8 * std::cos(2 * pi * (1.5 * along - phase)));
}

template <class Velocity>
double lineOf(glm::dvec2 p, double phase, const Velocity& velocity) {
  double sum = weightOf(0, phase) * grainOf(p), weights = weightOf(0, phase);
  for (const int way : {-1, 1}) {
    glm::dvec2 at = p;
    for (int i = 1; i <= 26; ++i) {
      const glm::dvec2 v(velocity(at.x, at.y));
      at += way * 0.75 / lineFine / std::sqrt(v.x * v.x + v.y * v.y) * v;
      at.x = std::clamp(at.x, 0.0, double{lineCells});
      at.y = std::clamp(at.y, 0.0, double{lineCells});
      sum += weightOf(way * i / 27.0, phase) * grainOf(at);
      weights += weightOf(way * i / 27.0, phase);
    }
  }
  return std::clamp(0.5 + 3.2 * (sum / weights - 0.5), 0.0, 1.0);
}

}  // namespace

TEST_CASE("flow lines are weighted means of the noise along the flow, in double precision") {
  // The flow rotates about a point off the centre. It is linear, so interpolation is exact.
  const auto turning = [](double x, double y) {
    return glm::vec2(static_cast<float>(-3 * (y - 10.7)), static_cast<float>(3 * (x - 13.2)));
  };
  const FluidTwin twin = movedBy(turning);
  const double time = 0.4;
  const double phase = static_cast<double>(twin.plan().linePhase(time));
  const std::vector<float> lines = twin.lines(time);
  constexpr int side = lineCells * lineFine;
  REQUIRE(lines.size() == side * side);
  int pixelDifference = 0, looked = 0;
  double minimum = 1, maximum = 0;
  for (int y = 12; y < side - 12; ++y)
    for (int x = 12; x < side - 12; ++x) {
      const glm::dvec2 at((x + 0.5) / lineFine, (y + 0.5) / lineFine);
      const double found = static_cast<double>(lines[static_cast<std::size_t>(y * side + x)]);
      // Occasionally, rounding moves a point of a line into the adjacent noise cell, so that one of 53
      // samples differs.
      pixelDifference += std::abs(found - lineOf(at, phase, turning)) > 1e-3 ? 1 : 0;
      ++looked;
      minimum = std::min(minimum, found);
      maximum = std::max(maximum, found);
    }
  CHECK(pixelDifference < 0.01 * looked);
  CHECK(minimum < 0.1);
  CHECK(maximum > 0.9);
}

TEST_CASE("lines of a uniform flow are correlated along it and not across it") {
  const auto even = [](double, double) { return glm::vec2(5, 0); };
  const std::vector<float> lines = movedBy(even).lines(0);
  constexpr int side = lineCells * lineFine;
  double along = 0, across = 0;
  for (int y = 1; y < side; ++y)
    for (int x = 1; x < side; ++x) {
      const auto at = [&](int i, int j) {
        return static_cast<double>(lines[static_cast<std::size_t>(j * side + i)]);
      };
      along += std::abs(at(x, y) - at(x - 1, y));
      across += std::abs(at(x, y) - at(x, y - 1));
    }
  CHECK(across > 2 * along);  // The image varies faster across the flow than along it, unlike pure noise.
}

TEST_CASE("a soft brush is 1 inside and fades to 0 at its rim by smoothstep of squared distance") {
  sim::FluidParameters p;
  p.size = {40, 40};
  sim::FluidStroke stroke;
  stroke.from = stroke.to = {20.2F, 19.4F, 0};
  stroke.radius = 12;
  stroke.setsDye = true;
  stroke.dye = glm::vec3(1, 0.5F, 0);
  for (const double soft : {0.0, 0.4, 1.0}) {
    stroke.soft = static_cast<float>(soft);
    p.strokes = {stroke};
    const FluidTwin twin(sim::FluidPlan(p, "bath", 1, 1.0 / 30));
    const double hard = 12 * (1 - soft);
    double worst = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const double dx = x + 0.5 - 20.2, dy = y + 0.5 - 19.4, square = dx * dx + dy * dy;
        double want = square <= 144 ? 1 : 0;
        if (soft > 0) {
          const double s = std::clamp((144 - square) / (144 - hard * hard), 0.0, 1.0);
          want = s * s * (3 - 2 * s);
        }
        const glm::dvec4 dye(twin.dye[twin.index(x, y)]);
        worst = std::max({worst, std::abs(dye.x - want), std::abs(dye.y - 0.5 * want)});
      }
    CHECK(worst < 5e-6);
  }
}

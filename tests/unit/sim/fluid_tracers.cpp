// Tests tracers by comparison with closed forms.
#include "reference/tracers_twin.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

// The flow is a solid-body rotation u = w x r, which bilinear sampling reproduces exactly. A tracer moves
// in a circle. The midpoint rule is ahead by an angle of w^3 dt^3 / 6 per step and moves outwards by w^4
// dt^4 / 8 of the radius.
TEST_CASE("tracers: tracers in a rotating flow move in circles") {
  const glm::ivec2 size(64, 64);
  const double w = 2;
  WindTwin wind{sim::fluidWindGrid({}, size)};
  for (int y = -1; y <= size.y; ++y)
    for (int x = -1; x <= size.x; ++x)
      wind.flow.emplace_back(-w * (y + 0.5 - 32), w * (x + 0.5 - 32), 0, 0);
  sim::TracerParameters p;
  p.count = 50;
  p.seconds = 1e5;
  const double dt = 1.0 / 120;
  TracersTwin twin(p, size, std::vector<std::uint8_t>(64 * 64), sim::tracerStep(p, dt, 3, false, false),
                   1.0 / 60);
  std::vector<glm::dvec2> before;
  for (glm::vec4& tracer : twin.tracers) {
    // The tracer is moved into the inscribed circle of the rectangle.
    tracer.x = 32 + 0.6F * (tracer.x - 32);
    tracer.y = 32 + 0.6F * (tracer.y - 32);
    before.emplace_back(tracer.x - 32.0, tracer.y - 32.0);
  }
  const int steps = 240;
  for (int i = 0; i < steps; ++i) twin.advance(wind);
  const double angle = w * dt * steps;
  const double early = steps * std::pow(w * dt, 3) / 6;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const glm::dvec2 a = before[i];
    const double c = std::cos(angle + early), s = std::sin(angle + early);
    const glm::dvec2 expected(c * a.x - s * a.y, s * a.x + c * a.y);
    CAPTURE(i);
    CHECK(std::abs(twin.tracers[i].x - 32 - expected.x) < 1e-3);
    CHECK(std::abs(twin.tracers[i].y - 32 - expected.y) < 1e-3);
  }
}

// The sum of a drawn streak's light is proportional to the length of the tracer's path. It is 4096 units
// per cell, minus truncation to integers.
TEST_CASE("tracers: a streak's light is proportional to its length") {
  const glm::ivec2 size(90, 40);
  WindTwin wind{sim::fluidWindGrid({}, size)};
  for (int i = 0; i < 92 * 42; ++i) wind.flow.emplace_back(30, 12, 0, 0);
  sim::TracerParameters p;
  p.count = 1;
  p.seconds = 1e5;
  TracersTwin twin(p, size, std::vector<std::uint8_t>(90 * 40), sim::tracerStep(p, 0.05, 3, false, false),
                   1);
  twin.tracers[0] = glm::vec4(10, 10, 0, 0);
  for (int i = 0; i < 20; ++i) twin.advance(wind);
  double sum = 0;
  for (const std::uint32_t level : twin.trail) sum += level;
  const double length = std::sqrt(30.0 * 30 + 12 * 12);
  CHECK(std::abs(twin.tracers[0].x - 40) < 1e-4);
  CHECK(std::abs(twin.tracers[0].y - 22) < 1e-4);
  CHECK(std::abs(sum - 4096 * length) < 0.01 * 4096 * length);
}

TEST_CASE("tracers: no tracer starts in an obstacle, and one that enters an obstacle restarts") {
  const glm::ivec2 size(40, 20);
  WindTwin wind{sim::fluidWindGrid({}, size)};
  for (int i = 0; i < 42 * 22; ++i) wind.flow.emplace_back(20, 0, 0, 0);
  std::vector<std::uint8_t> solid(800);
  for (int y = 0; y < 20; ++y)
    for (int x = 15; x < 22; ++x) solid[static_cast<std::size_t>(y * 40 + x)] = 1;
  sim::TracerParameters p;
  p.count = 300;
  p.seconds = 1e5;
  TracersTwin twin(p, size, solid, sim::tracerStep(p, 0.05, 3, false, false), 1);
  const auto inSolid = [&] {
    int count = 0;
    for (const glm::vec4& t : twin.tracers) count += t.x >= 15 && t.x < 22 ? 1 : 0;
    return count;
  };
  CHECK(inSolid() <= 2);  // A tracer makes four attempts. With probability (7 / 40)^4 none of them finds a
                          // free cell, which concerns few of the 300 tracers.
  for (int i = 0; i < 30; ++i) twin.advance(wind);
  CHECK(inSolid() <= 4);
  int anew = 0;
  for (const glm::vec4& t : twin.tracers) anew += t.w > 0 ? 1 : 0;
  CHECK(anew > 100);
}

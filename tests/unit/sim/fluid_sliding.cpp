// Tests obstacles that move through fluid at rest, with and without slip, by comparison with known results.
#include "reference/fluid_twin.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double bathFrame = 1.0 / 30;
using BathSide = sim::FluidSide::Kind;

scene::Animated<glm::vec3> keyedWay(glm::vec3 from, glm::vec3 to, double seconds) {
  return {{{0.0, from}, {seconds, to}}, scene::Ease::linear};
}

sim::FluidParameters quietBath(glm::ivec2 size, bool slip) {
  sim::FluidParameters p;
  p.size = size;
  p.speed = 60;
  p.strokes.clear();
  p.obstaclesSlip = slip;
  p.viscosity = 1.5F;
  p.cycles = 60;
  return p;
}

/// Returns the bath after one frame.
FluidTwin bathTwin(const sim::FluidParameters& p) {
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, bathFrame));
  twin.step(0);
  return twin;
}

}  // namespace

TEST_CASE("fluid: a circle that starts to move creates a dipole flow, with slip and no-slip") {
  // The potential flow around a circle of radius R and speed U is u = U R^2 (x^2 - y^2) / r^4 and v = 2 U
  // R^2 x y / r^4. Other effects are negligible after one short frame.
  auto p = quietBath({97, 91}, true);
  for (sim::FluidSide* side : {&p.left, &p.right, &p.top, &p.bottom}) side->kind = BathSide::open;
  p.viscosity = 0.0F;
  p.obstacles.resize(1);
  const glm::vec3 from(48.3F, 45.6F, 0);
  p.obstacles[0].center = keyedWay(from, from + glm::vec3(30, 0, 0), 1);
  p.obstacles[0].radius = 7;
  p.substeps = 4;
  const FluidTwin twin = bathTwin(p);
  const double middle = from.x + 30 * bathFrame;
  double worst = 0;
  for (int y = 20; y < 71; ++y)
    for (int x = 20; x < 77; ++x) {
      const double dx = x - middle, dy = y + 0.5 - from.y, r2 = dx * dx + dy * dy;
      const double ex = x + 0.5 - middle, ey = y - from.y, e2 = ex * ex + ey * ey;
      if (r2 < 90 || e2 < 90 || r2 > 400) continue;
      const double u = 30 * 49 * (dx * dx - dy * dy) / (r2 * r2), v = 30 * 49 * 2 * ex * ey / (e2 * e2);
      worst = std::max({worst, std::abs(twin.flow[twin.index(x, y)].x - u),
                        std::abs(twin.flow[twin.index(x, y)].y - v)});
    }
  MESSAGE("off by ", worst, " of 30 cells/s");
  CHECK(worst < 0.06 * 30);
}

TEST_CASE("fluid: a plate moving along itself drags the fluid with no-slip and does not with slip") {
  double along[2] = {0, 0};
  for (const bool slip : {false, true}) {
    auto p = quietBath({61, 31}, slip);
    p.left.kind = p.right.kind = BathSide::periodic;
    p.obstacles.resize(1);
    p.obstacles[0].shape = sim::FluidObstacle::Shape::box;
    p.obstacles[0].extent = {140, 5, 0};  // The bar extends beyond both ends of the bath.
    p.obstacles[0].center = keyedWay({30.5F, 15.5F, 0}, {50.5F, 15.5F, 0}, 1);
    p.viscosity = 60.0F;
    FluidTwin twin = bathTwin(p);
    twin.step(bathFrame);
    for (int x = 0; x < 61; ++x) along[slip ? 1 : 0] += twin.flow[twin.index(x, 19)].x / 61;
  }
  CHECK(along[0] > 3);
  CHECK(std::abs(along[1]) < 1e-3);
}

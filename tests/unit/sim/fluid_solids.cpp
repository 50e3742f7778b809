// Tests obstacles in fluids: sums over cut faces, obstacles from images, enclosed pockets, and moving
// obstacles.
#include "reference/fluid_twin.hpp"
#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

sim::FluidParameters emptyTank(int w, int h) {
  sim::FluidParameters p;
  p.size = {w, h};
  p.strokes.clear();
  p.substeps = 1;
  return p;
}

sim::FluidObstacle ballAt(float x, float y, float radius) {
  sim::FluidObstacle o;
  o.center = glm::vec3(x, y, 0);
  o.radius = radius;
  return o;
}

sim::FluidObstacle boxAt(glm::vec3 center, float w, float h) {
  sim::FluidObstacle o;
  o.shape = sim::FluidObstacle::Shape::box;
  o.center = center;
  o.extent = {w, h, 0};
  return o;
}

scene::Animated<glm::vec3> moving(glm::vec3 from, glm::vec3 to, double seconds) {
  return {{{0.0, from}, {seconds, to}}, scene::Ease::linear};
}

/// Returns the coverage of pixels by a ring around the middle, from 8x8 samples per pixel.
std::vector<double> ringPicture(int side, double inner, double outer) {
  std::vector<double> levels;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      int inside = 0;
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) {
          const double r = std::hypot(x + (i + 0.5) / 8 - side / 2.0, y + (j + 0.5) / 8 - side / 2.0);
          inside += r >= inner && r < outer ? 1 : 0;
        }
      levels.push_back(inside / 64.0);
    }
  return levels;
}

}  // namespace

TEST_CASE("fluid obstacles: cut faces of an obstacle close, and a linear pressure integrates to its area") {
  for (const bool turned : {false, true}) {
    auto p = emptyTank(61, 47);
    p.obstacles = {ballAt(30.3F, 22.8F, 9.4F)};
    double area = std::numbers::pi * 9.4 * 9.4;
    if (turned) {
      p.obstacles[0] = boxAt({30.3F, 22.8F, 0}, 21, 9.5F);
      p.obstacles[0].turn = 33;
      area = 21 * 9.5;
    }
    p.obstaclesSlip = true;  // The obstacles have no friction.
    const sim::FluidPlan plan(p, "bath", 1, 0.01);
    const auto solids = plan.solidsAt(0, 0);
    std::vector<glm::vec4> flow(static_cast<std::size_t>(plan.elements()), glm::vec4(0, 0, 0, 1));
    const glm::dvec2 even = sim::forceOn(p, *solids, 0, flow).all();
    CHECK(std::abs(even.x) < 1e-9);
    CHECK(std::abs(even.y) < 1e-9);
    for (int y = 0; y < 47; ++y)
      for (int x = 0; x < 61; ++x)
        flow[static_cast<std::size_t>((y + 1) * 63 + x + 1)].w = static_cast<float>(3 * x - 2 * y);
    const glm::dvec2 slope = sim::forceOn(p, *solids, 0, flow).all();
    CHECK(slope.x == doctest::Approx(-3 * area).epsilon(0.01));
    CHECK(slope.y == doctest::Approx(2 * area).epsilon(0.01));
    p.obstacles[0].measured = false;
    CHECK(sim::forceOn(p, *solids, 0, flow).all().x == 0);
  }
}

TEST_CASE("fluid obstacles: grey edges of an obstacle picture give subpixel positions") {
  const sim::PictureDistances ring({40, 40}, ringPicture(40, 9.3, 15.6), 0.5);
  double worst = 0;
  for (int j = -20; j < 180; ++j)
    for (int i = -20; i < 180; ++i) {
      const glm::dvec2 p(i / 4.0 + 0.1, j / 4.0 + 0.1);
      const double r = std::hypot(p.x - 20, p.y - 20);
      const double want = std::max(r - 15.6, 9.3 - r);
      if (std::abs(want) < 2) worst = std::max(worst, std::abs(ring.at(p) - want));
    }
  CHECK(worst < 0.2);
  CHECK(ring.at({20, 20}) > 7);
  CHECK(ring.at({-6, 20}) == doctest::Approx(26 - 15.6).epsilon(0.06));
}

TEST_CASE("fluid obstacles: a piston shrinks one pocket and widens the other uniformly") {
  auto p = emptyTank(60, 9);
  p.top.kind = p.bottom.kind = sim::FluidSide::Kind::slip;
  p.obstaclesSlip = true;
  p.speed = 10;
  p.obstacles = {boxAt({0, 0, 0}, 6.5F, 30)};
  p.obstacles[0].center = moving({20, 4.5F, 0}, {36, 4.5F, 0}, 2);  // The obstacle moves at 8 cells/s.
  const double dt = 0.05;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, dt));
  for (int i = 0; i < 12; ++i) {
    twin.step(i * dt);
    CHECK(twin.divergence() < sim::maxFluidDivergence);
  }
  CHECK(twin.solids().pockets() == 2);
  CHECK(twin.solids().grows());
  const double middle = 20 + 8 * 12 * dt;
  const double left = middle - 3.25, right = middle + 3.25;
  double worst = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 1; x < 60; ++x) {
      if (x > left - 1 && x < right + 1) continue;
      const double want = x < left ? 8 * x / left : 8 * (60 - x) / (60 - right);
      worst = std::max(worst, std::abs(want - twin.flow[twin.index(x, y)].x));
    }
  MESSAGE("off by ", worst, " of 8 cells/s");
  CHECK(worst < 0.001);
}

TEST_CASE(
    "fluid obstacles: the fluid enclosed by a rotating ring finally rotates with it, as a separate "
    "pocket") {
  auto p = emptyTank(37, 35);
  p.speed = 12;
  p.viscosity = 9.0F;
  sim::FluidObstacle drum = ballAt(18.3F, 17.6F, 0);
  drum.shape = sim::FluidObstacle::Shape::image;
  // The drum rotates at 1 rad/s.
  drum.turn = scene::Animated<float>({{0.0, 0.0F}, {100.0, 5729.578F}}, scene::Ease::linear);
  p.obstacles = {drum};
  const double dt = 0.02;
  const double radius = 8.7;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, dt,
                                {sim::PictureDistances({32, 32}, ringPicture(32, radius, 13), 0.5)}));
  CHECK(twin.solids().pockets() == 2);
  CHECK(twin.solids().pocketOf()[17 * 37 + 18] != twin.solids().pocketOf()[0]);
  for (int i = 0; i < 480; ++i) twin.step(i * dt);
  CHECK(twin.divergence() < sim::maxFluidDivergence);
  double worst = 0, pressure = 0;
  for (int y = 0; y < 35; ++y)
    for (int x = 0; x < 37; ++x) {
      if (std::hypot(x - 18.3, y + 0.5 - 17.6) > radius - 1) continue;
      const double want = -(y + 0.5 - 17.6);
      worst = std::max(worst, std::abs(want - twin.flow[twin.index(x, y)].x));
      pressure = std::max(pressure, std::abs(double{twin.flow[twin.index(x, y)].w}));
    }
  MESSAGE("off by ", worst, " of ", radius, " cells/s");
  CHECK(worst < 0.005 * radius);
  CHECK(pressure < 2 * radius * radius);  // The bound shows that the mean pressure does not drift.
}

TEST_CASE("fluid tiles: each tile is in exactly one list, and open tiles have only whole faces") {
  for (const bool wraps : {false, true}) {
    auto p = emptyTank(101, 83);
    if (wraps) p.left.kind = p.right.kind = sim::FluidSide::Kind::periodic;
    p.obstacles = {ballAt(60, 40, 9)};
    const sim::FluidPlan plan(p, "tank", 1, 1.0 / 30);
    const auto solids = plan.solidsAt(0, 0);
    int start = solids->tilesStart(), open = 0;
    for (std::size_t number = 0; number < plan.levels().levels().size(); ++number) {
      const sim::FluidLevel& level = plan.levels().levels()[number];
      const glm::ivec2 tiles = level.tiles();
      std::vector<int> found(static_cast<std::size_t>(tiles.x * tiles.y));
      for (int which = 0; which < 2; ++which, start += level.listElements())
        for (int i = 0; i < 4 * level.listElements(); ++i) {
          const unsigned word = solids->words()[static_cast<std::size_t>(start + i / 4)][i % 4];
          if (word == ~0U) continue;
          CHECK(i < 4 * solids->tileGroups()[number][which]);
          const int x = static_cast<int>(word & 0xffffU), y = static_cast<int>(word >> 16U);
          ++found.at(static_cast<std::size_t>(y * tiles.x + x));
          if (which == 1) continue;
          ++open;
          bool whole = true;
          for (int j = 4 * y - 2; j < 4 * y + 6; ++j)
            for (int k = 4 * x - 2; k < 4 * x + 6; ++k) {
              const bool inside = k >= 0 && j >= 0 && k < level.cells.x / 2 && j < level.cells.y / 2;
              const int block = level.start + j * level.blocks().x + k;
              whole = whole && inside &&
                      solids->words()[static_cast<std::size_t>(block)] == glm::uvec4(4096U | 4096U << 16U);
            }
          CHECK(whole);
        }
      CHECK(std::count(found.begin(), found.end(), 1) == std::ssize(found));
    }
    CHECK(start == std::ssize(solids->words()));
    CHECK(open > 40);
  }
}

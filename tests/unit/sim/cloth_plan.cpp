#include "sim/cloth/plan.hpp"
#include "sim/core/shader_code.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("the sheet starts flat, centred, last row pinned") {
  const sim::ClothPlan plan(sim::ClothParameters{}, 1, 1.0 / 60, {});
  const auto positions = plan.firstPositions();
  REQUIRE(positions.size() == 32 * 32);
  CHECK(positions[0].x == doctest::Approx(-1.55));
  CHECK(positions[0].y == 0.0F);
  CHECK(positions[0].z == doctest::Approx(-1.55));
  CHECK(positions[31].x == doctest::Approx(1.55));
  CHECK(positions[0].w == 1.0F);
  for (std::size_t i = 0; i < 32; ++i) CHECK(positions[31 * 32 + i].w == 0.0F);
}

TEST_CASE("pins by row, column, corner and point") {
  sim::ClothParameters p;
  p.size = {5, 4};
  sim::PinGroup group;
  group.rows = {0};
  group.every = 3;
  CHECK(p.pinnedBy(group) == std::vector<int>{0, 3, 4});
  group = {};
  group.columns = {-1};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 9, 14, 19});
  group = {};
  group.corners = {1, 2};
  group.points = {{2, 1}, {2, 1}};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 7, 15});
}

TEST_CASE("auto takes as many substeps as the springs need") {
  sim::ClothParameters p;
  p.substeps.reset();
  // w = sqrt(4 * 500 * 2.3 / 1) = 67.8 1/s, limit 2/w = 29.5 ms, times 0.7 = 20.6 ms: one substep of 16.7
  // ms.
  CHECK(p.substepsPerFrame(1.0 / 60) == 1);
  p.stiffness = 50000;
  CHECK(p.stableSeconds() == doctest::Approx(2.0 / std::sqrt(4 * 50000 * 2.3)).epsilon(1e-6));
  CHECK(p.substepsPerFrame(1.0 / 60) == 9);
}

TEST_CASE("damping does not depend on the number of substeps") {
  sim::ClothParameters p;
  for (const int n : {1, 4, 9}) {
    p.substeps = n;
    sim::ClothPlan plan(p, 1, 1.0 / 60, {});
    double kept = 1;
    for (const auto& step : plan.frame(0)) kept *= step.kept;
    CHECK(kept == doctest::Approx(std::exp(-4.85 / 60)).epsilon(1e-5));
  }
}

// Tests the vertical sides that close the ground of water.
#include "sim/water/skirt.hpp"

#include <algorithm>
#include <cstddef>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

sim::WaterPlan basin() {
  sim::WaterParameters p;
  p.size = {9, 5};
  p.cell = 0.5F;
  p.position = {1, 2, 3};
  p.bed = -0.5F;
  return {p, "w", 1, 1.0 / 60};
}

}  // namespace

TEST_CASE("water: the sides of the ground reach from the rim to below the lowest bed, and face outwards") {
  const sim::WaterPlan plan = basin();
  const sim::Mesh sides = sim::groundSides(plan, 1, 0.1F);  // only the west side has a rim
  CHECK(sides.positions.size() == 2 * 2 * (9 + 5));
  CHECK(sides.indices.size() == 6 * 2 * (8 + 4));
  float west = -1e9F, east = -1e9F, lowest = 1e9F;
  for (const glm::vec3& at : sides.positions) {
    if (at.x < 1) west = std::max(west, at.y);
    if (at.x > 1) east = std::max(east, at.y);
    lowest = std::min(lowest, at.y);
  }
  CHECK(west == doctest::Approx(2.1));
  CHECK(east == doctest::Approx(1.5));
  CHECK(lowest == doctest::Approx(2 - 0.5 - 0.25));
  for (std::size_t i = 0; i < sides.indices.size(); i += 3) {
    const glm::vec3 a = sides.positions[sides.indices[i]], b = sides.positions[sides.indices[i + 1]],
                    c = sides.positions[sides.indices[i + 2]];
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    CHECK(glm::dot(normal, sides.normals[sides.indices[i]]) > 0.999F);
    CHECK(glm::dot(normal, a - glm::vec3(1, a.y, 3)) > 0);
  }
}

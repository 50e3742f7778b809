// Tests that polygons are split into triangles correctly. The areas must add up to the polygon's area, and
// no triangle may be flipped.
#include "sim/polygons/cut.hpp"

#include "sim/polygons/problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::test::polygons_cut {

namespace {

/// Checks the polygon with its list of corners rotated in every possible way.
void checkCut(std::vector<glm::vec3> corners) {
  const double area = glm::length(sim::polygonNormal(corners)) / 2;
  const glm::dvec3 up = sim::polygonNormal(corners) / (2 * area);
  for (std::size_t turn = 0; turn < corners.size(); ++turn) {
    std::vector<std::array<unsigned, 3>> triangles;
    sim::PolygonCutter().cut(corners, triangles);
    REQUIRE(triangles.size() == corners.size() - 2);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const glm::dvec3 from(corners[a]);
      const double part =
          glm::dot(glm::cross(glm::dvec3(corners[b]) - from, glm::dvec3(corners[c]) - from), up) / 2;
      CHECK(part > -1e-6);
      sum += part;
    }
    CHECK(sum == doctest::Approx(area));
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

/// Checks the polygon on several planes, and from its back side.
void checkEverywhere(const std::vector<glm::vec2>& flat) {
  std::vector<glm::vec3> across, aside, slanted;
  for (const glm::vec2& p : flat) {
    across.emplace_back(p, 0);
    aside.emplace_back(7, p.x, p.y);
    slanted.emplace_back(p.x, p.y - p.x, 2 * p.x + p.y);
  }
  for (std::vector<glm::vec3> corners : {across, aside, slanted}) {
    checkCut(corners);
    std::reverse(corners.begin(), corners.end());
    checkCut(corners);
  }
}

}  // namespace

TEST_CASE("polygons with holes are triangulated without their holes") {
  // a polygon in the shape of an arrow
  checkEverywhere({{0, 0}, {2, 0}, {2, 2}, {1, 0.5F}});
  checkEverywhere({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});  // a polygon in the shape of an L
  checkEverywhere(
      {{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 4}, {4, 4}, {4, 1}, {0, 1}});  // a polygon in the shape of a U
  // a square with extra corners on its straight sides
  checkEverywhere({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  checkEverywhere(
      // a square with a hole, connected by a double edge
      {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
  std::vector<glm::vec2> star;
  for (int i = 0; i < 20; ++i) {
    const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 10;
    star.push_back((i % 2 == 0 ? 3.0F : 1.0F) * glm::vec2(std::cos(angle), std::sin(angle)));
  }
  checkEverywhere(star);
}

TEST_CASE("triangulation of self-intersecting, zero-area and very large polygons ends") {
  std::vector<std::array<unsigned, 3>> triangles;
  sim::PolygonCutter cutter;
  cutter.cut(std::vector<glm::vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 0}}, triangles);
  cutter.cut(std::vector<glm::vec3>(7, glm::vec3(1)), triangles);
  CHECK(triangles.size() == 8);
  // The polygon is a comb with concave teeth.
  std::vector<glm::vec3> comb;
  for (int i = 0; i < 4999; ++i) comb.emplace_back(i, i % 2 == 0 ? 100 : 0, 0);
  comb.emplace_back(2500, -1e6F, 0);
  std::reverse(comb.begin(), comb.end());
  const auto again = [&] {
    for (int i = 0; i < 1000; ++i) {
      triangles.clear();
      cutter.cut(comb, triangles);
    }
  };
  CHECK_THROWS_AS(again(), sim::PolygonProblem);
}

}  // namespace simreel::test::polygons_cut

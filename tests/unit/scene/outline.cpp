// Tests the outermost of many points, which cameras frame.
#include "scene/outline.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns points evenly distributed on a unit sphere (golden angle).
std::vector<glm::vec3> evenBall(int count) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.399963229728653 * i;
    const double y = -1 + (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - y * y);
    points.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
  }
  return points;
}

float farthest(const std::vector<glm::vec3>& points, const glm::vec3& way) {
  float maximum = -1e9F;
  for (const glm::vec3& point : points) maximum = std::max(maximum, glm::dot(point, way));
  return maximum;
}

}  // namespace

TEST_CASE("outline: a subset of a ball's points loses at most 5% of the extent in any direction") {
  const std::vector<glm::vec3> points = evenBall(20000);
  const std::vector<glm::vec3> outer = scene::outermost(points);
  CHECK(outer.size() == 98);
  for (const glm::vec3& way : evenBall(999)) {
    CHECK(farthest(outer, way) <= farthest(points, way));
    CHECK(farthest(outer, way) > 0.95F);
  }
}

TEST_CASE("outline: the result does not depend on the point order, also with ties") {
  std::vector<glm::vec3> points;
  // points of a cube of 10x10x10 cells
  for (int i = 0; i < 1000; ++i) points.emplace_back(i % 10, (i / 10) % 10, i / 100);
  const std::vector<glm::vec3> outer = scene::outermost(points, 0.05, 0.1F);
  std::reverse(points.begin(), points.end());
  CHECK(scene::outermost(points, 0.05, 0.1F) == outer);
  std::rotate(points.begin(), points.begin() + 317, points.end());
  CHECK(scene::outermost(points, 0.05, 0.1F) == outer);
}

TEST_CASE("outline: a few stray points are ignored, by an integer rule") {
  std::vector<glm::vec3> points = evenBall(199);
  points.emplace_back(50, 0, 0);
  const glm::vec3 right(1, 0, 0);
  CHECK(farthest(scene::outermost(points, 0.0049), right) ==
        50);  // The fraction 0.49 % of 200 points is less than one, so no point may be left out.
  CHECK(farthest(scene::outermost(points, 0.005), right) <
        1.01F);  // With 0.5 % of 200 points, one point may be left out.
  CHECK(farthest(scene::outermost(points, 0.005, 0.25F), right) > 1.2F);
  CHECK(scene::outermost({}).empty());
  CHECK(scene::outermost(std::vector<glm::vec3>{right}, 1).size() == 98);
}

TEST_CASE("outline: balls are framed with their radii, and a large one is never a stray") {
  std::vector<glm::vec4> balls;
  for (const glm::vec3& point : evenBall(199)) balls.emplace_back(point, 0.01F);
  balls.emplace_back(3, 0, 0, 0.01F);
  const glm::vec3 right(1, 0, 0);
  CHECK(farthest(scene::outermostOfBalls(balls), right) == doctest::Approx(3.01));
  CHECK(farthest(scene::outermostOfBalls(balls, 0.005), right) < 1.02F);
  balls.back().w = 0.5F;
  CHECK(farthest(scene::outermostOfBalls(balls, 0.005), right) == doctest::Approx(3.5));
  const std::vector<glm::vec3> outer = scene::outermostOfBalls(balls, 0.02);
  std::reverse(balls.begin(), balls.end());
  CHECK(scene::outermostOfBalls(balls, 0.02) == outer);
  CHECK(scene::outermostOfBalls({}).empty());
  CHECK(farthest(scene::outermostOfBalls(std::vector<glm::vec4>{{1, 0, 0, 2}}, 1), right) == 3);
}

TEST_CASE("outline: balls of one radius have the outline of their centres, moved outwards by the radius") {
  std::vector<glm::vec3> points = evenBall(300);
  std::vector<glm::vec4> balls;
  for (const glm::vec3& point : points) balls.emplace_back(point, 0.25F);
  const auto expected = scene::outermost(points, 0.01, 0.25F), outer = scene::outermostOfBalls(balls, 0.01);
  REQUIRE(outer.size() == expected.size());
  for (std::size_t i = 0; i < outer.size(); ++i) CHECK(glm::length(outer[i] - expected[i]) < 1e-6F);
}

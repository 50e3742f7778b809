#include "sim/core/path.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("an object beside a path is to the right of its direction, at its height") {
  const std::vector<glm::vec3> path = {{0, 0, 0}, {4, 0, 0}, {4, 0, 4}};
  scene::PathPlace place;
  place.height = 2;
  place.side = 0.25F;
  place.progress = 0.25F;  // The place is on the part along +x, where +z is to the right.
  sim::Standing standing = sim::standingBy(path, place, 0);
  CHECK(standing.position == glm::vec3(2, 2, 0.25F));
  CHECK(standing.ahead == glm::vec3(1, 0, 0));
  place.side = -1;
  place.progress = 0.75F;  // The place is on the part along +z, where +x is to the left.
  standing = sim::standingBy(path, place, 0);
  CHECK(standing.position == glm::vec3(5, 2, 2));
  place.progress = 0.5F;  // The place is at the corner between the two parts.
  standing = sim::standingBy(path, place, 0);
  CHECK(standing.ahead.x == doctest::Approx(std::sqrt(0.5)));
  CHECK(standing.ahead.z == doctest::Approx(std::sqrt(0.5)));
  place.progress = 0.0F;  // Before its start, the path is extended in a straight line.
  CHECK(sim::standingBy(path, place, 0).position == glm::vec3(0, 2, -1));
  CHECK(sim::standingBy({{1, 2, 3}}, place, 0).position == glm::vec3(0, 4, 3));
}

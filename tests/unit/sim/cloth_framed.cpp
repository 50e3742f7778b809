// Tests the box that a camera without a position frames for a cloth.
#include "sim/cloth/parameters.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

void checkBox(const sim::ClothParameters& cloth, const glm::vec3& min, const glm::vec3& max) {
  const auto box = cloth.framed();
  REQUIRE(box.has_value());
  for (int k = 0; k < 3; ++k) {
    CHECK(box->min[k] == doctest::Approx(min[k]).epsilon(1e-5));
    CHECK(box->max[k] == doctest::Approx(max[k]).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE("cloth: automatic framing contains the sheet at rest and where it will hang") {
  sim::ClothParameters cloth;  // The cloth's last row is pinned.
  cloth.size = {11, 6};
  cloth.spacing = 0.2F;
  cloth.position = {1, 2, 3};
  checkBox(cloth, {0, 1, 2.5F}, {2, 2, 3.5F});
  cloth.pins[0] = {};
  cloth.pins[0].corners = {0};  // The cloth is pinned at one corner, so it hangs by its diagonal.
  checkBox(cloth, {0, 2 - std::sqrt(5.0F), 2.5F}, {2, 2, 3.5F});
  cloth.pins[0] = {};
  cloth.pins[0].rows = {0, -1};
  checkBox(cloth, {0, 2, 2.5F}, {2, 2, 3.5F});
}

TEST_CASE(
    "cloth: without pins, framing contains the fall to height 0, or below that a fall as deep as the sheet "
    "is wide") {
  sim::ClothParameters cloth;
  cloth.pins.clear();
  cloth.size = {11, 6};
  cloth.spacing = 0.2F;
  cloth.position = {0, 2, 0};
  checkBox(cloth, {-1, 0, -0.5F}, {1, 2, 0.5F});
  cloth.position.y = -1;
  checkBox(cloth, {-1, -3, -0.5F}, {1, -1, 0.5F});
}

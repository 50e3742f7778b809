#include "sim/core/turn.hpp"

#include "sim/core/collider.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("rotations by quarter turns are exact, and by zero keep every bit") {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const glm::vec2 exact[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    CHECK(sim::cosineAndSine(90.0F * static_cast<float>(quarter)) == exact[(quarter + 12) % 4]);
  }
  CHECK(sim::rotationMatrix({0, 0, 0}) == glm::mat4(1));
  const glm::vec4 place(0.1F, -0.7F, 1e-20F, 1);
  CHECK(sim::rotationMatrix({0, 360, -720}) * place == place);
  CHECK(sim::rotationMatrix({0, 90, 0}) * place == glm::vec4(place.z, place.y, -place.x, 1));
  CHECK(sim::rotationMatrix({90, 0, 0}) * place == glm::vec4(place.x, -place.z, place.y, 1));
  for (const float degrees : {1e-3F, 30.0F, 89.999F, -271.5F, 3000.1F}) {
    const double radians = static_cast<double>(degrees) * 0.017453292519943295;
    CHECK(std::abs(sim::cosineAndSine(degrees).x - std::cos(radians)) < 5e-6);
    CHECK(std::abs(sim::cosineAndSine(degrees).y - std::sin(radians)) < 5e-6);
  }
}

// Tests interpolation between keyframes.
#include "scene/value/animated.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

using simreel::scene::Animated;
using simreel::scene::Ease;

TEST_CASE("keyframes: a spline passes through its keys with continuous speed") {
  const Animated<float> value({{0, 1.0F}, {1, 2.0F}, {3, 7.0F}, {3.5, 7.5F}, {5, 3.0F}}, Ease::spline);
  for (const auto& key : value.keys()) CHECK(value.at(key.time) == key.value);
  const auto speed = [&](double time) { return (value.at(time + 1e-4) - value.at(time - 1e-4)) / 2e-4; };
  for (const double time : {0.0, 1.0, 3.0, 3.5, 5.0}) {
    CAPTURE(time);
    CHECK(std::abs(speed(time - 2e-3) - speed(time + 2e-3)) < 0.1);
  }
  CHECK(speed(0.002) == doctest::Approx(0).scale(1).epsilon(0.02));
  CHECK(speed(1) > 0.5);
  // Fritsch and Butland use weighted harmonic means. In this test, the slopes are 1 and 2.5 over intervals
  // of 1 and 2 s.
  CHECK(speed(1) == doctest::Approx((5 + 4) / (5 / 1.0 + 4 / 2.5)).epsilon(0.01));
  for (int i = 0; i < 1000; ++i) {
    const double time = 5.0 * i / 1000;
    CHECK(value.at(time) >= 1.0F);  // Values must stay within the range of the keys.
    CHECK(value.at(time) <= 7.5F);
    if (time < 3.5) CHECK(value.at(time + 0.005) >= value.at(time));
  }
}

TEST_CASE("keyframes: a spline with even steps is nearly straight") {
  const Animated<glm::vec3> place({{0, glm::vec3(0)}, {1, {1, 2, -1}}, {2, {2, 4, -2}}, {3, {3, 6, -3}}},
                                  Ease::spline);
  for (int i = 0; i <= 10; ++i) {
    const double time = 1 + 0.1 * i;
    CHECK(glm::length(place.at(time) - static_cast<float>(time) * glm::vec3(1, 2, -1)) < 1e-5F);
  }
}

TEST_CASE("keyframes: a hold key keeps its value until the next key") {
  const Animated<float> value({{0, 1.0F}, {1, 2.0F}, {2, 5.0F}}, Ease::hold);
  CHECK(value.at(-1) == 1.0F);
  CHECK(value.at(0.999) == 1.0F);
  CHECK(value.at(1) == 2.0F);
  CHECK(value.at(1.999) == 2.0F);
  CHECK(value.at(9) == 5.0F);
}

TEST_CASE("keyframes: two keys at one time make a jump") {
  for (const Ease ease : {Ease::linear, Ease::smooth, Ease::spline, Ease::hold}) {
    CAPTURE(static_cast<int>(ease));
    const Animated<float> value({{0, 0.0F}, {1, 2.0F}, {1, 10.0F}, {2, 12.0F}}, ease);
    CHECK(value.at(1) == 10.0F);
    if (ease == Ease::hold) continue;
    CHECK(value.at(1 - 1e-6) == doctest::Approx(2).epsilon(1e-4));
    CHECK(value.at(1 + 1e-6) == doctest::Approx(10).epsilon(1e-4));
  }
  // A spline must neither slow down before a jump nor start with speed 0 after it.
  const Animated<float> cut({{0, 0.0F}, {1, 2.0F}, {1, 10.0F}, {2, 12.0F}}, Ease::spline);
  CHECK((cut.at(1 - 1e-3) - cut.at(1 - 2e-3)) / 1e-3 == doctest::Approx(2).epsilon(0.02));
  CHECK((cut.at(1 + 2e-3) - cut.at(1 + 1e-3)) / 1e-3 == doctest::Approx(2).epsilon(0.02));
}

TEST_CASE("keyframes: the time of a value's last jump is found") {
  const double never = -std::numeric_limits<double>::infinity();
  const Animated<float> cut({{0, 1.0F}, {1, 2.0F}, {1, 5.0F}, {2, 5.0F}, {2, 5.0F}, {3, 0.0F}},
                            Ease::linear);
  CHECK(cut.jumpedBy(0.999) == never);
  CHECK(cut.jumpedBy(1) == 1.0);  // At the time of the jump, the value is that of the second key.
  CHECK(cut.at(1) == 5.0F);
  CHECK(cut.jumpedBy(9) == 1.0);  // Two keys with equal values are not a jump.
  const Animated<float> steps({{0, 1.0F}, {1, 2.0F}, {2, 2.0F}}, Ease::hold);
  CHECK(steps.jumpedBy(0.5) == never);
  CHECK(steps.jumpedBy(1.5) == 1.0);
  CHECK(steps.jumpedBy(2.5) == 1.0);
  CHECK(Animated<float>(3.0F).jumpedBy(9) == never);
}

// Tests a camera that lags behind its target by comparison with closed forms of a critically damped spring.
#include "sim/world/lag.hpp"

#include <array>
#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Returns y at `time` for a target x that moves at constant `speed` v. Both start at 0, and y starts at
/// rest. The result is v (t - T + (t + T) e^(-2t/T)) with the damping T.
double ramp(double speed, double damping, double time) {
  return speed * (time - damping + (time + damping) * std::exp(-2 * time / damping));
}

}  // namespace

TEST_CASE("lag: damped following of steady motion equals the equation at any frame rate") {
  for (const double fps : {10.0, 60.0, 1000.0})
    for (const double damping : {0.1, 0.5, 3.0}) {
      CAPTURE(fps);
      CAPTURE(damping);
      sim::Lag lag(damping, 1 / fps);
      lag.follow({1, 2, 3});
      for (int frame = 1; frame <= 2 * static_cast<int>(fps); ++frame) {
        const double time = frame / fps;
        lag.follow(glm::dvec3(1, 2, 3) + time * glm::dvec3(4, 0, -1));
        const auto place = lag.place();
        REQUIRE(place);
        CHECK(std::abs(double{place->x} - 1 - ramp(4, damping, time)) < 2e-6);
        CHECK(place->y == 2.0F);
        CHECK(std::abs(double{place->z} - 3 - ramp(-1, damping, time)) < 2e-6);
      }
    }
}

TEST_CASE("lag: the response to a step is 1 - (1 + w t) e^-wt") {
  constexpr double damping = 0.4, fps = 2000;
  sim::Lag lag(damping, 1 / fps);
  lag.follow(glm::dvec3(0));
  for (int frame = 1; frame <= 4000; ++frame) {
    lag.follow(glm::dvec3(1, 0, 0));
    // The target rises within one frame. This acts like a step in the middle of the frame.
    const double at = 2 / damping * (frame - 0.5) / fps;
    if (frame > 2) CHECK(std::abs(double{lag.place()->x} - (1 - (1 + at) * std::exp(-at))) < 2e-6);
  }
  CHECK(lag.place()->x > 0.999F);
  CHECK(lag.place()->x < 1);  // The camera does not overshoot.
}

TEST_CASE("lag: a lost target is reacquired at rest, and a carried-over state continues unchanged") {
  class Words final : public sim::CarryOver {
   public:
    void array(const char* /*name*/, gl::Buffer& /*buffer*/) override { FAIL("no buffers"); }
    std::array<std::int64_t, 16> words{};
    std::size_t count = 0;
    bool back = false;

   private:
    void word(const char* /*name*/, std::int64_t& bits) override {
      (back ? bits : words.at(count)) = back ? words.at(count) : bits;
      ++count;
    }
  };
  sim::Lag lag(0.3, 0.1);
  CHECK(!lag.place());
  for (const double x : {0.0, 1.0, 1.5}) lag.follow(glm::dvec3(x, 1, 0));
  Words words;
  lag.visitCheckpointData(words);
  CHECK(words.count == 10);
  words.back = true;
  words.count = 0;
  sim::Lag other(0.3, 0.1);
  other.visitCheckpointData(words);
  for (const double x : {2.0, 0.0, 7.0}) {
    lag.follow(glm::dvec3(x, 1, 0));
    other.follow(glm::dvec3(x, 1, 0));
    CHECK(*lag.place() == *other.place());
  }
  lag.lose();
  CHECK(!lag.place());
  lag.follow(glm::dvec3(9, 0, 0));
  CHECK(*lag.place() == glm::vec3(9, 0, 0));
}

// Tests the penumbra of a sun with a disc, by running its shader file on the CPU.
#include "draw/picture_code.hpp"
#include "reference/disc_points.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

using namespace simreel;

namespace {

/// Returns the depth of the nearest caster at a texel of the shadow map.
std::function<float(glm::ivec2)> casters;

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
float casterNear(glm::ivec2 texel) {
  return casters(texel);
}
#define FUNCTION inline
#define precise
#define discPoints discPoints()
#include "glsl/draw/exact/shadows/sun_disc.glsl"
#undef discPoints
#undef precise
#undef FUNCTION

/// Returns a receiver whose penumbra has a radius of 100 texels per unit of map depth.
SunReceiver receiver(glm::vec2 middle, float near) {
  return {middle, near, {0, 0}, 100.0F, 1.0F, 60.0F};
}

/// Returns the fraction of a unit disc that is farther than x from its centre along one axis. This is the
/// visible part of the sun behind an edge.
double beyond(double x) {
  if (x <= -1 || x >= 1) return x < 0 ? 1 : 0;
  return (std::acos(x) - x * std::sqrt(1 - x * x)) / std::numbers::pi;
}

}  // namespace

TEST_CASE(
    "sun disc: behind an edge, light grows with the visible fraction of the disc, over a penumbra "
    "proportional to the gap") {
  casters = [](glm::ivec2 texel) { return texel.x < 500 ? 0.9F : -1e30F; };
  for (const float gap : {0.1F, 0.25F, 0.5F}) {
    const double radius = 100.0 * static_cast<double>(gap);  // radius of the penumbra in texels
    double worst = 0;
    for (float x = 430; x <= 570; x += 0.71F) {
      const double wanted = beyond((500.0 - static_cast<double>(x)) / radius);
      const double found = static_cast<double>(sunDiscFraction(receiver({x, 300.3F}, 0.9F - gap)));
      worst = std::max(worst, std::abs(found - wanted));
    }
    CAPTURE(gap);
    CHECK(worst < 0.04);  // The tolerance is the error of 32 sample points on the disc.
  }
}

TEST_CASE("sun disc: penumbrae have the width of the sun's disc") {
  // Width between 10 and 90 % of the light, as the mean over edges in 16 directions.
  constexpr int directions = 16;
  constexpr double radius = 50, ends = 0.6870;  // beyond(0.6870) is 0.1
  double sum = 0;
  for (int i = 0; i < directions; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.3) / directions;
    const glm::dvec2 across(std::cos(turn), std::sin(turn));
    casters = [&](glm::ivec2 texel) {
      return glm::dot(glm::dvec2(texel) + 0.5 - 500.0, across) < 0 ? 0.9F : -1e30F;
    };
    double shade = 0;  // integral of the light between 10 and 90 %
    for (double x = -70; x <= 70; x += 0.25) {
      const auto light = static_cast<double>(sunDiscFraction(
          receiver(glm::vec2(500.0 + x * across), 0.9F - static_cast<float>(radius) / 100)));
      if (light > 0.1 && light < 0.9) shade += 0.25;
    }
    sum += shade / directions;
  }
  CHECK(sum == doctest::Approx(2 * ends * radius).epsilon(0.02));
}

TEST_CASE("sun disc: penumbra width is clamped to its min and max") {
  casters = [](glm::ivec2 texel) { return texel.x < 500 ? 0.9F : -1e30F; };
  const auto at = [](float x, float near) { return sunDiscFraction(receiver({x, 300.3F}, near)); };
  CHECK(at(502.5F, 0.899F) == 1);
  CHECK(at(497.5F, 0.899F) == 0);
  CHECK(at(500.0F, 0.899F) == doctest::Approx(0.5).epsilon(0.1));
  CHECK(at(561.5F, -0.5F) == 1);
  CHECK(at(438.5F, -0.5F) == 0);
  CHECK(at(450.0F, -0.5F) > 0);
  CHECK(at(700.0F, -20.0F) == 1);  // A receiver far behind all objects is not shaded.
}

TEST_CASE("sun disc: a caster in the receiver's plane casts no shadow; a standing caster does") {
  // The plane rises by 0.004 per texel along x and falls by 0.002 along y.
  const glm::vec2 rise(0.004F, -0.002F);
  const auto plane = [&](glm::vec2 at) { return 0.5F + rise.x * (at.x - 400) + rise.y * (at.y - 400); };
  SunReceiver r = receiver({400, 400}, 0.5F + 5e-3F);
  r.rise = rise;
  casters = [&](glm::ivec2 texel) { return plane(glm::vec2(texel)); };
  CHECK(sunDiscFraction(r) == 1);
  r.rise = {0, 0};
  CHECK(sunDiscFraction(r) < 0.7F);
  r.rise = rise;
  casters = [&](glm::ivec2 texel) { return plane(glm::vec2(texel)) + (texel.x > 400 ? 0.2F : 0.0F); };
  CHECK(sunDiscFraction(r) == doctest::Approx(0.5).epsilon(0.1));
}

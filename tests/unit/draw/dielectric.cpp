// Tests Fresnel's equations and Snell's law for a dielectric surface, and rays through clear solids,
// against double precision.
#include "draw/picture_code.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

using namespace simreel;

namespace dielectric {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
#define FUNCTION inline
#define precise
#include "glsl/draw/exact/surface/refraction.glsl"
#undef precise
#undef FUNCTION

/// Computes the reflectance from the angles a of incidence and b of refraction. The amplitudes are sin(a -
/// b) / sin(a + b) and tan(a - b) / tan(a + b).
double mirrored(double angle, double eta) {
  const double sine = eta * std::sin(angle);
  if (sine >= 1) return 1;
  if (angle < 1e-6) return std::pow((eta - 1) / (eta + 1), 2);
  const double beyond = std::asin(sine);
  const double across = std::sin(angle - beyond) / std::sin(angle + beyond);
  const double along = std::tan(angle - beyond) / std::tan(angle + beyond);
  return 0.5 * (across * across + along * along);
}

}  // namespace dielectric

TEST_CASE("clear surfaces: reflection follows Fresnel's equations from both sides") {
  double worst = 0;
  for (const double eta : {1 / 1.5, 1 / 1.33, 1 / 2.42, 1.5, 1.33, 2.42})
    for (int i = 0; i < 1800; ++i) {
      const double angle = i * 3.14159265358979 / 3600;
      const double critical = eta > 1 ? std::asin(1 / eta) : 2;
      if (std::abs(angle - critical) < 2e-4)
        continue;  // Skips the critical angle, where the curve is too steep.
      const auto found = static_cast<double>(
          dielectric::dielectricFresnel(static_cast<float>(std::cos(angle)), static_cast<float>(eta)));
      worst = std::max(worst, std::abs(found - dielectric::mirrored(angle, eta)));
    }
  CHECK(worst < 2e-4);
  // At Brewster's angle, only one polarization is reflected.
  const double brewster = std::atan(1.5);
  const double across = std::cos(2 * brewster);
  CHECK(dielectric::dielectricFresnel(static_cast<float>(std::cos(brewster)), 1 / 1.5F) ==
        doctest::Approx(0.5 * across * across).epsilon(1e-4));
}

TEST_CASE("clear surfaces: refraction follows Snell's law") {
  const glm::vec3 normal = glm::normalize(glm::vec3(0.2F, 1, -0.4F));
  const glm::vec3 aside = glm::normalize(glm::cross(normal, glm::vec3(1, 0, 0)));
  double worst = 0, length = 0;
  for (const double eta : {1 / 1.5, 1 / 2.42, 1.33})
    for (int i = 1; i < 480; ++i) {
      const double angle = i * 0.1 * 3.14159265358979 / 180;
      const glm::vec3 view =
          normal * static_cast<float>(std::cos(angle)) + aside * static_cast<float>(std::sin(angle));
      const glm::vec3 found = dielectric::refractedDirection(view, normal, static_cast<float>(eta));
      CHECK(glm::dot(found, normal) < 0);
      worst =
          std::max(worst, std::abs(static_cast<double>(-glm::dot(found, aside)) - eta * std::sin(angle)));
      length = std::max(length, std::abs(static_cast<double>(glm::length(found)) - 1));
    }
  CHECK(worst < 1e-6);
  CHECK(length < 1e-6);
}

TEST_CASE("clear solids: rays through a ball and through a slab are exact") {
  constexpr double radius = 0.7, thick = 0.3;
  const glm::vec3 up(0, 0, 1);
  double worst = 0;
  const auto check = [&](const dielectric::Crossing& crossing, double metres, const glm::dvec3& direction,
                         const glm::dvec3& place) {
    worst = std::max({worst, std::abs(static_cast<double>(crossing.metres) - metres),
                      glm::length(glm::dvec3(crossing.direction) - direction),
                      glm::length(glm::dvec3(crossing.place) - place)});
  };
  for (const double ior : {1.33, 1.5, 2.42})
    for (int i = 1; i < 85; ++i) {
      const double angle = i * 3.14159265358979 / 180, beyond = std::asin(std::sin(angle) / ior);
      const glm::dvec3 towards(std::sin(angle), 0, std::cos(angle));
      const glm::dvec3 inside(-std::sin(beyond), 0, -std::cos(beyond));
      // The centre of the ball is straight below the entry. The ray turns by the same angle at both ends.
      const glm::dvec3 leaving = -2 * radius * std::cos(angle) * towards;
      const glm::dvec3 outward = leaving / radius + glm::dvec3(0, 0, 1);
      const double last = 2 * beyond - angle, chord = 2 * radius * std::cos(beyond);
      check(dielectric::crossingOf(glm::vec3(0), glm::vec3(towards), up, static_cast<float>(1 / radius),
                                   glm::vec3(leaving), glm::vec3(outward), static_cast<float>(ior)),
            chord, {-std::sin(last), 0, -std::cos(last)}, chord * inside);
      const double across = thick / std::cos(beyond);
      check(dielectric::crossingOf(glm::vec3(0), glm::vec3(towards), up, 0,
                                   glm::vec3(towards * (-thick / std::cos(angle))), -up,
                                   static_cast<float>(ior)),
            across, -towards, across * inside);
    }
  CHECK(worst < 2e-5);
}

// Tests the lobe of draw/surface/shading.glsl on the CPU. Compares it with its equations, implemented
// independently in double precision, and the fit of its reflection of uniform surroundings with the
// integral.
#include "draw/picture_code.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

using namespace simreel;

namespace {

namespace lobes = simreel::shader;

/// Returns Smith's Lambda of GGX for a direction whose cosine with the normal is c.
double hidden(double c, double alpha) {
  const double tan2 = 1 / (c * c) - 1;
  return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

/// Returns pi D G2 F / (4 nl nv) as x and y, so that the value is F0 x + y, where y is white. The normal is
/// the z axis.
glm::dvec2 lobeOf(glm::dvec3 view, glm::dvec3 light, double alpha) {
  const glm::dvec3 half = glm::normalize(view + light);
  const double cos2 = half.z * half.z;
  const double spread = alpha * alpha + 1 / cos2 - 1;
  const double facets = alpha * alpha / (cos2 * cos2 * spread * spread);  // pi times the distribution D
  const double seen = 1 / (1 + hidden(view.z, alpha) + hidden(light.z, alpha));
  const double fifth = std::pow(1 - glm::dot(light, half), 5);
  const double all = facets * seen / (4 * view.z * light.z);
  return {all * (1 - fifth), all * fifth};
}

/// Integrates lobeOf() / pi times the cosine over the hemisphere of light directions. The half vectors are
/// distributed by D.
glm::dvec2 mirroredOf(double nv, double alpha) {
  constexpr int steps = 173;
  const glm::dvec3 view(std::sqrt(1 - nv * nv), 0, nv);
  glm::dvec2 sum(0);
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double u = (i + 0.5) / steps;
      const double turn = std::numbers::pi * (j + 0.5) / steps;  // The angle covers only half a turn. The
                                                                 // second half is a mirror image.
      const double cosine = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u));
      const double sine = std::sqrt(1 - cosine * cosine);
      const glm::dvec3 half(sine * std::cos(turn), sine * std::sin(turn), cosine);
      const double vh = glm::dot(view, half);
      const glm::dvec3 light = 2 * vh * half - view;
      if (vh <= 0 || light.z <= 1e-9) continue;
      const double spread = alpha * alpha + 1 / (cosine * cosine) - 1;
      const double often = alpha * alpha / (std::pow(cosine, 3) * spread * spread) /
                           (4 * vh);  // density of light directions, times pi
      sum += lobeOf(view, light, alpha) * (light.z / often);
    }
  return sum / static_cast<double>(steps * steps);
}

}  // namespace

TEST_CASE("lobes: the lobe is GGX with Smith shadowing and Schlick Fresnel, and is reciprocal") {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), up(0.03, 1), rough(0.25, 1);
  const auto direction = [&] {
    const double z = up(engine), angle = turn(engine), across = std::sqrt(1 - z * z);
    return glm::dvec3(across * std::cos(angle), across * std::sin(angle), z);
  };
  for (int i = 0; i < 3001; ++i) {
    const glm::dvec3 view = direction(), light = direction();
    const double alpha = std::pow(rough(engine), 2);
    const glm::dvec2 wanted = lobeOf(view, light, alpha);
    const glm::vec2 there =
        lobes::lobe({0, 0, 1}, glm::vec3(view), glm::vec3(light), static_cast<float>(alpha));
    const glm::vec2 back =
        lobes::lobe({0, 0, 1}, glm::vec3(light), glm::vec3(view), static_cast<float>(alpha));
    if (wanted.x + wanted.y > 59) continue;
    // D uses 1.00001 instead of 1, so that it is finite on smooth surfaces.
    CHECK(there.x == doctest::Approx(wanted.x).epsilon(2e-3).scale(1e-3));
    CHECK(there.y == doctest::Approx(wanted.y).epsilon(2e-3).scale(1e-3));
    CHECK(back.x == doctest::Approx(there.x).epsilon(1e-5));
  }
  // The reflection of a light's centre in a mirror is limited to the brightness that pixels can show.
  const glm::vec2 smooth = lobes::lobe({0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 0.002F);
  CHECK(smooth.x == 60);
  CHECK(smooth.y < 1e-20F);
}

TEST_CASE("lobes: the reflected fraction of uniform light is the lobe's integral") {
  double worst = 0, worstWhite = 0;
  for (int i = 0; i <= 19; ++i)
    for (const double nv : {0.05, 0.1, 0.17, 0.3, 0.45, 0.6, 0.8, 0.95, 1.0}) {
      const double roughness = std::fmax(i / 19.0, 0.05);
      const glm::dvec2 wanted = mirroredOf(nv, roughness * roughness);
      const glm::vec2 fit = lobes::ambientLobe(static_cast<float>(roughness), static_cast<float>(nv));
      const double all = std::abs(fit.x + fit.y - wanted.x - wanted.y), white = std::abs(fit.y - wanted.y);
      const double counts = nv < 0.1 ? 0.55 : nv < 0.2 ? 0.75 : 1;
      worst = std::fmax(worst, counts * all);
      worstWhite = std::fmax(worstWhite, counts * white);
      CAPTURE(roughness);
      CAPTURE(nv);
      CHECK(counts * all < 0.033);
      CHECK(counts * white < 0.026);
      CHECK(fit.x >= 0);
      CHECK(fit.x + fit.y <= 1.00001F);
      if (nv > 0.5) CHECK(white < 0.006);  // The error is small compared with F0 = 0.04.
    }
  MESSAGE("largest error of x + y ", worst, ", of y ", worstWhite);
  // At roughness 1, the integral has a closed form: 1 - nv ln(1 + 1 / nv).
  for (const double nv : {0.1, 0.25, 0.5, 0.75, 1.0}) {
    const double wanted = 1 - nv * std::log(1 + 1 / nv);
    const glm::dvec2 sum = mirroredOf(nv, 1);
    CHECK(sum.x + sum.y == doctest::Approx(wanted).epsilon(2e-3).scale(0));
    const glm::vec2 fit = lobes::ambientLobe(1, static_cast<float>(nv));
    CHECK(std::abs(fit.x + fit.y - wanted) < 0.032);
  }
  // For a mirror, the fit is almost exactly Schlick's term.
  for (const double nv : {0.1, 0.5, 1.0}) {
    const glm::vec2 fit = lobes::ambientLobe(0, static_cast<float>(nv));
    CHECK(fit.y == doctest::Approx(std::pow(1 - nv, 5)).epsilon(1e-5));
    CHECK(fit.x + fit.y == doctest::Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("shares: under a white sky a white ball reflects all light and a black one what its lobe does") {
  for (const double roughness : {0.2, 0.5, 0.8, 1.0}) {
    CAPTURE(roughness);
    double wanted = 0, found = 0;
    constexpr int rings = 12;  // Points are on rings of equal area within the ball's outline.
    for (int i = 0; i < rings; ++i) {
      const double nv = std::sqrt(1 - (i + 0.5) / rings);
      const glm::dvec2 lobe = mirroredOf(nv, roughness * roughness);
      const auto shares = [&](float base) {
        return lobes::barycentricWeights(glm::vec3(base), static_cast<float>(roughness), 0,
                                         static_cast<float>(nv));
      };
      wanted += (0.04 * lobe.x + lobe.y) / rings;
      found += static_cast<double>(shares(0).mirrored.x) / rings;
      CHECK(shares(0).matt.x == 0);
      CHECK(shares(1).matt.x + shares(1).mirrored.x == doctest::Approx(1).epsilon(1e-6));
    }
    CHECK(std::abs(found - wanted) < 0.006);  // The bound is the error of the fit. The fraction itself is
                                              // 0.03 to 0.07.
  }
}

// Tests the colours of black bodies and the white balance.
#include "draw/black_body.hpp"

#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

glm::dvec3 xyzOf(glm::dvec3 rgb) {
  return {0.4124564 * rgb.r + 0.3575761 * rgb.g + 0.1804375 * rgb.b,
          0.2126729 * rgb.r + 0.7151522 * rgb.g + 0.0721750 * rgb.b,
          0.0193339 * rgb.r + 0.1191920 * rgb.g + 0.9503041 * rgb.b};
}

/// Integrates Planck's law with the CIE 1931 observer, approximated by the fit of Wyman, Sloan and Shirley
/// (JCGT 2, 2013).
glm::dvec3 planck(double kelvin) {
  const auto lobe = [](double at, double middle, double below, double above) {
    const double t = (at - middle) / (at < middle ? below : above);
    return std::exp(-0.5 * t * t);
  };
  glm::dvec3 sum(0);
  for (double nm = 360; nm <= 830; nm += 1) {
    const double metres = nm * 1e-9;
    const double light = std::pow(metres, -5) / std::expm1(1.438776877e-2 / (metres * kelvin));
    sum += light * glm::dvec3(1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                                  0.065 * lobe(nm, 501.1, 20.4, 26.2),
                              0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
                              1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8));
  }
  return sum / sum.y;
}

glm::dvec2 placeOf(glm::dvec3 xyz) {
  return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
}

}  // namespace

TEST_CASE(
    "black body: colours equal CIE illuminant A and Planck's law integrated over the standard observer") {
  const glm::dvec2 a = placeOf(xyzOf(draw::blackBodyColor(2855.6)));  // illuminant A, for which CIE 15
                                                                      // gives the chromaticity (0.44758,
                                                                      // 0.40745)
  CHECK(std::abs(a.x - 0.44758) < 1e-3);
  CHECK(std::abs(a.y - 0.40745) < 1e-3);
  for (const double kelvin : {2000., 2700., 3999., 4001., 5000., 6504., 9000., 15000., 25000.}) {
    CAPTURE(kelvin);
    const glm::dvec3 color = draw::blackBodyColor(kelvin);
    const glm::dvec2 made = placeOf(xyzOf(color)), wanted = placeOf(planck(kelvin));
    CHECK(glm::length(made - wanted) < 6e-3);
    CHECK(xyzOf(color).y == doctest::Approx(1).epsilon(1e-5));
  }
  const glm::vec3 ember = draw::blackBodyColor(1667);
  CHECK(ember.z == 0.0F);  // The colour is outside sRGB, so blue is clamped to 0.
  CHECK(ember.x > 2 * ember.y);
}

TEST_CASE("white balance: the light it is set for becomes grey") {
  for (const double kelvin : {2000., 2700., 4500., 6504., 12000., 25000.}) {
    CAPTURE(kelvin);
    const glm::vec3 shown = draw::whiteBalance(kelvin) * draw::blackBodyColor(kelvin);
    CHECK(shown.x == doctest::Approx(shown.y).epsilon(1e-4));
    CHECK(shown.z == doctest::Approx(shown.y).epsilon(1e-4));
    CHECK(shown.y == doctest::Approx(1).epsilon(1e-4));
  }
  // A balance for warm light makes white bluish; a balance for cool light makes it yellowish.
  CHECK((draw::whiteBalance(3000) * glm::vec3(1)).z > 1.2F);
  CHECK((draw::whiteBalance(12000) * glm::vec3(1)).z < 0.9F);
}

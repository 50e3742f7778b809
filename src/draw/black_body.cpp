#include "draw/black_body.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace simreel::draw {

namespace {

// XYZ of the sRGB primaries (IEC 61966-2-1), one per column.
const glm::dmat3 xyzOfRgb(glm::dvec3(0.4124564, 0.2126729, 0.0193339),
                          glm::dvec3(0.3575761, 0.7151522, 0.1191920),
                          glm::dvec3(0.1804375, 0.0721750, 0.9503041));
const glm::dmat3 bradford(glm::dvec3(0.8951, -0.7502, 0.0389), glm::dvec3(0.2664, 1.7135, -0.0685),
                          glm::dvec3(-0.1614, 0.0367, 1.0296));

/// Returns the XYZ colour of a black body, scaled to Y = 1.
glm::dvec3 blackBody(double kelvin) {
  const double k = 1000 / kelvin;
  const double x = kelvin < 4000 ? ((-0.2661239 * k - 0.2343589) * k + 0.8776956) * k + 0.179910
                                 : ((-3.0258469 * k + 2.1070379) * k + 0.2226347) * k + 0.240390;
  const double y = kelvin < 2222   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                   : kelvin < 4000 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                   : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  return {x / y, 1, (1 - x - y) / y};
}

}  // namespace

glm::vec3 blackBodyColor(double kelvin) {
  const glm::dvec3 rgb = glm::max(glm::inverse(xyzOfRgb) * blackBody(kelvin), glm::dvec3(0));
  const glm::dvec3 luminance(xyzOfRgb[0].y, xyzOfRgb[1].y, xyzOfRgb[2].y);
  return rgb / glm::dot(rgb, luminance);
}

// Scales the cone responses so that those for the black body become equal to those for the white of sRGB
// (1, 1, 1).
glm::mat3 whiteBalance(double kelvin) {
  const glm::dvec3 from = bradford * blackBody(kelvin);
  const glm::dvec3 to = bradford * (xyzOfRgb * glm::dvec3(1));
  glm::dmat3 scale(0);
  for (int i = 0; i < 3; ++i) scale[i][i] = to[i] / from[i];
  return glm::inverse(xyzOfRgb) * glm::inverse(bradford) * scale * bradford * xyzOfRgb;
}

}  // namespace simreel::draw

#include "golden/compare/flip_colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace simreel::golden {

namespace {

/// Linear RGB to XYZ relative to white: rows of the sRGB matrix (exact fractions of the primaries'
/// chromaticities), each divided by its sum. Column-major, as GLM wants it.
glm::dmat3 relativeXyz() {
  const glm::dvec3 x(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794);
  const glm::dvec3 y(2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897);
  const glm::dvec3 z(1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382);
  const auto relative = [](const glm::dvec3& row) { return row / (row.x + row.y + row.z); };
  return glm::transpose(glm::dmat3(relative(x), relative(y), relative(z)));
}

struct Matrices {
  glm::mat3 toXyz = glm::mat3(relativeXyz());
  glm::mat3 toRgb = glm::mat3(glm::inverse(relativeXyz()));
};
const Matrices matrices;

std::array<float, 256> linearTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = double(i) / 255;
    table[i] = static_cast<float>(value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92);
  }
  return table;
}
const std::array<float, 256> linearOf = linearTable();

/// CIELAB's cube root, with its line near 0.
float labRoot(float t) {
  constexpr float delta = 6.0f / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29;
}

/// |dL| + sqrt(da^2 + db^2), to the power of qc = 0.7.
float poweredHyab(const HuntLab& a, const HuntLab& b) {
  const float da = a.a - b.a, db = a.b - b.b;
  return std::pow(std::abs(a.l - b.l) + std::sqrt(da * da + db * db), 0.7f);
}

}  // namespace

float linear(std::uint8_t value) {
  return linearOf[value];
}

Ycxcz toYcxcz(float r, float g, float b) {
  const glm::vec3 xyz = matrices.toXyz * glm::vec3(r, g, b);
  return {116 * xyz.y, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

LinearRgb clampedLinearRgb(const Ycxcz& colour) {
  const float y = colour.y / 116;
  const glm::vec3 rgb = matrices.toRgb * glm::vec3(y + colour.cx / 500, y, y - colour.cz / 200);
  return {std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f), std::clamp(rgb.z, 0.0f, 1.0f)};
}

HuntLab toHuntLab(const LinearRgb& colour) {
  const glm::vec3 xyz = matrices.toXyz * glm::vec3(colour.r, colour.g, colour.b);
  const float x = labRoot(xyz.x), y = labRoot(xyz.y), z = labRoot(xyz.z);
  const float l = 116 * y - 16, hunt = 0.01f * l;
  return {l, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

float colourError(const HuntLab& a, const HuntLab& b) {
  // Errors up to pc of the largest take the range up to pt, the rest what is left.
  constexpr float pc = 0.4f, pt = 0.95f;
  static const float largest = poweredHyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1}));
  const float error = poweredHyab(a, b), knee = pc * largest;
  if (error < knee) return pt / knee * error;
  return pt + (error - knee) / (largest - knee) * (1 - pt);
}

}  // namespace simreel::golden

// Tests normal maps, clear coat and sheen. Runs their shader files on the CPU and compares the results with
// the equations, which are implemented independently in double precision.
#include "draw/picture_code.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

using namespace simreel;

namespace {

namespace finish {
using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
#define FUNCTION inline
#define precise
#include "glsl/draw/surface/coat.glsl"
#include "glsl/draw/surface/normal_map.glsl"
#include "glsl/draw/surface/sheen.glsl"
#undef precise
#undef FUNCTION
}  // namespace finish

/// Random numbers from -1 to 1.
struct Numbers {
  double operator()() { return from(engine); }
  glm::dvec3 unit() {
    glm::dvec3 v(0);
    while (glm::length(v) < 0.1 || glm::length(v) > 1) v = {(*this)(), (*this)(), (*this)()};
    return glm::normalize(v);
  }
  std::mt19937 engine{7};
  std::uniform_real_distribution<double> from{-1, 1};
};

/// A triangle's plane with uvs, on which position = origin + u tangent + v bitangent. Tangent and bitangent
/// are arbitrary.
struct Plane {
  glm::dvec3 tangent, bitangent;
  [[nodiscard]] glm::dvec3 normal() const { return glm::normalize(glm::cross(tangent, bitangent)); }
  /// Returns the change of uv along a vector of the plane.
  [[nodiscard]] glm::dvec2 uvAlong(glm::dvec3 step) const {
    const glm::dvec3 solved = glm::inverse(glm::dmat3(tangent, bitangent, normal())) * step;
    return {solved.x, solved.y};
  }
};

/// Returns the normal in MikkTSpace's frame. There, the tangent is along u, and the bitangent is a cross
/// product with the sign of the uv's handedness. y of a glTF normal map points against v.
glm::dvec3 mikkNormal(const Plane& plane, glm::dvec3 front, glm::dvec3 t) {
  const glm::dvec3 n = front;
  const glm::dvec3 along = glm::normalize(plane.tangent - n * glm::dot(n, plane.tangent));
  glm::dvec3 up = glm::cross(n, along);
  if (glm::dot(up, plane.bitangent) > 0) up = -up;
  return glm::normalize(t.x * along + t.y * up + t.z * n);
}

glm::dvec3 mapped(const Plane& plane, glm::dvec3 normal, glm::dvec3 t, glm::dvec3 across,
                  glm::dvec3 above) {
  return finish::mappedNormal(glm::vec3(t), glm::vec3(normal), glm::vec3(across), glm::vec3(above),
                              glm::vec2(plane.uvAlong(across)), glm::vec2(plane.uvAlong(above)));
}

}  // namespace

TEST_CASE("normal maps: tangent frames equal MikkTSpace for any orientation of uvs and pixels") {
  Numbers number;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    Plane plane{number.unit() * 0.3, number.unit() * 2.0};
    if (glm::length(glm::cross(plane.tangent, plane.bitangent)) < 0.1) continue;
    const glm::dvec3 flat = plane.normal() * (i % 2 == 0 ? 1.0 : -1.0);
    const glm::dvec3 aside = glm::normalize(glm::cross(flat, number.unit()));
    const double turn = number();
    const glm::dvec3 across = 1e-3 * aside;
    const glm::dvec3 above =
        1.7e-3 * (glm::cross(flat, aside) * (i % 3 == 0 ? -1.0 : 1.0) + 0.4 * turn * aside);
    const glm::dvec3 t = glm::normalize(glm::dvec3(number(), number(), 1.2));
    worst =
        std::max(worst, glm::distance(mapped(plane, flat, t, across, above), mikkNormal(plane, flat, t)));
  }
  CHECK(worst < 2e-5);
}

TEST_CASE("normal maps: red tilts along u, green upwards in the picture") {
  const Plane plane{{1, 0, 0}, {0, -1, 0}};  // v points down, as in an image seen from +z.
  const glm::dvec3 n(0, 0, 1), across(0.01, 0, 0), above(0, 0.01, 0);
  CHECK(mapped(plane, n, {0.6, 0, 0.8}, across, above).x == doctest::Approx(0.6));
  CHECK(mapped(plane, n, {0, 0.6, 0.8}, across, above).y == doctest::Approx(0.6));
  const Plane mirrored{{-1, 0, 0}, {0, -1, 0}};
  CHECK(mapped(mirrored, n, {0.6, 0, 0.8}, across, above).x == doctest::Approx(-0.6));
  CHECK(mapped(mirrored, n, {0, 0.6, 0.8}, across, above).y == doctest::Approx(0.6));
  const glm::vec3 half = finish::tangentNormal({0.75F, 0.5F, 1.0F}, 0.5F);
  CHECK(half.x == doctest::Approx(0.25));
  CHECK(finish::tangentNormal({0.75F, 0.5F, 0.2F}, 1).z == doctest::Approx(0.05));
  // Without uvs the normal map has no effect.
  CHECK(finish::mappedNormal({0.6F, 0, 0.8F}, {0, 0, 1}, {0.01F, 0, 0}, {0, 0.01F, 0}, {0, 0}, {0, 0}).z ==
        doctest::Approx(1));
}

TEST_CASE("normal maps: normals that vary within a pixel increase its roughness") {
  CHECK(finish::spreadRoughness(0.3F, {0.5F, 0.5F, 1.0F}) == 0.3F);
  // A unit normal rounded to bytes adds no roughness.
  CHECK(finish::spreadRoughness(0.3F, {0.5F, 0.5F, 0.996F}) == 0.3F);
  const double length = 0.8;
  const double shorter = (0.99 - length) / length;
  const double wanted = std::pow(std::pow(0.3, 4) + 2 * shorter, 0.25);
  CHECK(finish::spreadRoughness(0.3F, {0.5F, 0.5F, 0.9F}) == doctest::Approx(wanted).epsilon(1e-4));
}

TEST_CASE("clear coat: the base loses the light that the coat reflects") {
  for (const float roughness : {0.0F, 0.2F, 0.7F})
    for (const float nv : {0.05F, 0.4F, 1.0F}) {
      const glm::vec2 share = finish::ambientLobe(roughness, nv);  // lobes.cpp tests ambientLobe().
      const double mirrored = 0.04 * static_cast<double>(share.x) + static_cast<double>(share.y);
      const glm::vec3 light = finish::coated({1, 2, 4}, {0.5F, 0, 0}, 0.6F, roughness, nv);
      CHECK(light.y == doctest::Approx(2 * (1 - 0.6 * mirrored)).epsilon(1e-5));
      CHECK(light.x == doctest::Approx((1 - 0.6 * mirrored) + 0.6 * 0.5).epsilon(1e-5));
    }
  CHECK(finish::coated({1, 2, 4}, {9, 9, 9}, 0, 0.1F, 0.5F) == glm::vec3(1, 2, 4));
}

TEST_CASE("sheen: the lobe and its integral equal their formula") {
  Numbers number;
  const glm::dvec3 n(0, 0, 1);
  for (int i = 0; i < 500; ++i) {
    glm::dvec3 view = number.unit(), light = number.unit();
    view.z = std::abs(view.z) + 0.05;
    light.z = std::abs(light.z) + 0.05;
    view = glm::normalize(view);
    light = glm::normalize(light);
    const double roughness = 0.2 + 0.4 * (number() + 1);
    const double alpha = roughness * roughness;
    const double cosine = glm::normalize(view + light).z;
    const double spread =
        (2 + 1 / alpha) * std::pow(1 - cosine * cosine, 0.5 / alpha) / (2 * std::numbers::pi);
    const double seen = 1 / (4 * (light.z + view.z - light.z * view.z));
    const double lobe =
        finish::sheenLobe(n, glm::vec3(view), glm::vec3(light), static_cast<float>(roughness));
    CHECK(lobe == doctest::Approx(std::numbers::pi * spread * seen).epsilon(2e-3).scale(0.01));
  }
  // For uniform light of 1, integrates D V cos over the hemisphere by the midpoint rule with 200 x 200
  // parts.
  for (const double roughness : {0.3, 0.5, 0.9})
    for (const double nv : {0.3, 0.6, 1.0}) {
      const glm::dvec3 view(std::sqrt(1 - nv * nv), 0, nv);
      double sum = 0;
      constexpr int parts = 200;
      for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
          const double polar = (i + 0.5) / parts * std::numbers::pi / 2,
                       turn = (j + 0.5) / parts * 2 * std::numbers::pi;
          const glm::dvec3 light(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                 std::cos(polar));
          sum += finish::sheenLobe(n, glm::vec3(view), glm::vec3(light), static_cast<float>(roughness)) /
                 std::numbers::pi * light.z * std::sin(polar) * (std::numbers::pi / 2 / parts) *
                 (2 * std::numbers::pi / parts);
        }
      CHECK(std::abs(finish::sheenAlbedo(static_cast<float>(roughness), static_cast<float>(nv)) - sum) <
            0.06);
    }
  // Fibres reduce the light from below by the light that they reflect.
  const float kept = finish::underFibres({1, 1, 1}, {0, 0, 0}, {0, 0, 0}, {0.5F, 0.25F, 0}, 0.5F, 0.3F).x;
  CHECK(kept == doctest::Approx(1 - 0.5 * finish::sheenAlbedo(0.5F, 0.3F)));
  const glm::vec3 own = finish::underFibres({0, 0, 0}, {2, 2, 2}, {1, 1, 1}, {0.5F, 0.25F, 0}, 0.5F, 0.3F);
  CHECK(own.y == doctest::Approx(0.25 * (2 + finish::sheenAlbedo(0.5F, 0.3F))));
}

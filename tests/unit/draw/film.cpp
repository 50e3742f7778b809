// Tests the tone curves from light to a picture, and pictures without a background.
#include "draw/picture_code.hpp"

#include <array>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#define FUNCTION inline
#define precise
#define EXACT_PICTURE
namespace simreel::shader {
#include "glsl/draw/overlay/pixel.glsl"
#include "glsl/draw/screen/cover.glsl"
}  // namespace simreel::shader
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

using namespace simreel;

namespace {

/// Implements AgX independently: log2 over 16.5 stops, the powers of the curve one by one, and gamma 2.2.
glm::dvec3 agx(glm::dvec3 light) {
  const glm::dmat3 inset(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992,
                         0.878468636469772, 0.0784336, 0.0792237451477643, 0.0791661274605434,
                         0.879142973793104);
  glm::dvec3 v = inset * light;
  for (int i = 0; i < 3; ++i) {
    const double x = std::fmin(std::fmax((std::log2(v[i]) + 12.47393) / (12.47393 + 4.026069), 0), 1);
    v[i] = 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) -
           6.868 * std::pow(x, 3) + 0.4298 * x * x + 0.1191 * x - 0.00232;
  }
  v = glm::inverse(inset) * v;
  for (int i = 0; i < 3; ++i) v[i] = std::pow(std::fmin(std::fmax(v[i], 0), 1), 2.2);
  return v;
}

/// Implements Hable's curve with its author's constants: A 0.15, B 0.5, C 0.1, D 0.2, E 0.02, F 0.3, white
/// 11.2.
double hable(double light) {
  const auto curve = [](double x) {
    return (x * (0.15 * x + 0.1 * 0.5) + 0.2 * 0.02) / (x * (0.15 * x + 0.5) + 0.2 * 0.3) - 0.02 / 0.3;
  };
  return std::fmin(curve(2 * light) / curve(11.2), 1);
}

constexpr std::array<float, 9> lights = {1e-4F, 0.003F, 0.02F, 0.18F, 0.5F, 1, 3, 20, 400};

}  // namespace

TEST_CASE("film: AgX and filmic equal their published definitions") {
  for (const float r : lights)
    for (const float g : lights)
      for (const float b : {0.01F, 0.3F, 5.0F}) {
        CAPTURE(r);
        CAPTURE(g);
        CAPTURE(b);
        const glm::vec3 light(r, g, b);
        const glm::vec3 soft = shader::filmedAgx(light), shoulder = shader::filmedFilmic(light);
        const glm::dvec3 wanted = agx(light);
        for (int i = 0; i < 3; ++i) {
          CHECK(std::abs(static_cast<double>(soft[i]) - wanted[i]) < 2e-4);
          CHECK(std::abs(static_cast<double>(shoulder[i]) - hable(static_cast<double>(light[i]))) < 2e-6);
        }
      }
}

TEST_CASE("film: grey stays grey, the curve is monotonic, and zero light is black") {
  const auto check = [](auto film) {
    float before = -1;
    for (float light = 1e-3F; light < 100; light *= 1.1F) {
      const glm::vec3 shown = film(glm::vec3(light));
      CHECK(std::abs(shown.x - shown.y) < 2e-3F);
      CHECK(std::abs(shown.z - shown.y) < 2e-3F);
      CHECK(shown.y >= before);
      before = shown.y;
    }
    CHECK(before > 0.85F);
    CHECK(film(glm::vec3(0)).y < 1e-3F);
  };
  check([](glm::vec3 light) { return shader::filmedAces(light); });
  check([](glm::vec3 light) { return shader::filmedAgx(light); });
  check([](glm::vec3 light) { return shader::filmedFilmic(light); });
}

TEST_CASE("transparent: partly covered pixels store unpremultiplied light of the covering surface") {
  // An object covers a quarter of the pixel. Its light is composited over the background.
  CHECK(shader::coverOf(0.25F, glm::vec3(0)) == 0.25F);
  const glm::vec3 own = shader::lightOfCover(0.25F * glm::vec3(0.8F, 2, 0.1F), 0.25F);
  CHECK(own.x == doctest::Approx(0.8F));
  CHECK(own.y == doctest::Approx(2));
  // Compositing the result over any background must equal drawing over that background.
  const float hidden = shader::coverOf(0.25F, glm::vec3(0.1F, 0.2F, 0.05F));
  CHECK(hidden == doctest::Approx(0.25 + 0.75 * 0.2));
  CHECK(shader::coverOf(0, glm::vec3(9)) == 1.0F);
  CHECK(shader::coverOf(1, glm::vec3(0)) == 1.0F);
  CHECK(shader::lightOfCover(glm::vec3(0), 0) == glm::vec3(0));
}

TEST_CASE("transparent: light beyond that of a white surface counts as added light") {
  CHECK(shader::lightBeyondCover(glm::vec3(0.25F, 0.75F, 0.5F), 0.25F, 2) == glm::vec3(0, 0.25F, 0));
  // A pixel that only the surface covers has the surface's colour. A pixel of a glow alone has the glow's.
  const glm::vec3 surface(0.4F, 0.5F, 0.6F), glow(0.2F, 0.1F, 0);
  CHECK(shader::colorOfCover(surface, 1, glow, 1) == surface);
  const glm::vec3 alone = shader::colorOfCover(surface, 0, glow, shader::coverOf(0, glow));
  CHECK(alone.x == doctest::Approx(1));
  CHECK(alone.y == doctest::Approx(0.5));
  CHECK(shader::colorOfCover(surface, 0, glm::vec3(0), 0) == glm::vec3(0));
  // Five sixths of this pixel's alpha belong to the surface. The straight colour of the glow is (1, 0.5,
  // 0).
  const glm::vec3 mixed = shader::colorOfCover(surface, 0.5F, glow, 0.6F);
  CHECK(mixed.x == doctest::Approx(5 / 6. * 0.4 + 1 / 6. * 1));
  CHECK(mixed.y == doctest::Approx(5 / 6. * 0.5 + 1 / 6. * 0.5));
  CHECK(mixed.z == doctest::Approx(5 / 6. * 0.6));
}

TEST_CASE("transparent: compositing over any background gives the same result as drawing over it") {
  for (const double alpha : {0., 1., 100., 254., 255.})
    for (const float opacity : {0.0F, 0.3F, 0.85F, 1.0F}) {
      const glm::vec3 color(0.9F, 0.2F, 0.5F);
      const glm::dvec3 before(200, 30, 90);
      const glm::vec4 made =
          shader::laidOver(glm::vec4(glm::vec3(before), alpha), glm::vec4(color * opacity, opacity));
      const double cover = static_cast<double>(made.w) / 255;
      CHECK(std::abs(cover - (static_cast<double>(opacity) +
                              (1 - static_cast<double>(opacity)) * alpha / 255)) < 0.0025);
      for (const double behind : {0., 128., 255.})
        for (int i = 0; i < 3; ++i) {
          const double seen = before[i] * alpha / 255 + behind * (1 - alpha / 255);
          const double wanted =
              255 * static_cast<double>(color[i] * opacity) + seen * (1 - static_cast<double>(opacity));
          const double got = static_cast<double>(made[i]) * cover + behind * (1 - cover);
          CHECK(std::abs(got - wanted) < 1.3);
        }
    }
}

// Tests lights as they are passed to shaders: flicker, order, units, and the functions of point_light.glsl
// on the CPU.
#include "base/hash.hpp"
#include "draw/lights/flicker.hpp"
#include "draw/lights/lamp_values.hpp"
#include "draw/picture_code.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
#define FUNCTION inline
#define precise
#include "glsl/draw/lights/point_light.glsl"
#undef precise
#undef FUNCTION

/// Implements the hash of Jarzynski and Olano independently. Returns the first word of the hash of a, b, c,
/// scaled to -1 to 1.
double hashed(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  constexpr std::uint64_t mask = 0xffffffffU;
  std::uint64_t v[] = {a, b, c};
  for (auto& word : v) word = (word * 1664525 + 1013904223) & mask;
  const auto mix = [&] {
    v[0] = (v[0] + v[1] * v[2]) & mask;
    v[1] = (v[1] + v[2] * v[0]) & mask;
    v[2] = (v[2] + v[0] * v[1]) & mask;
  };
  mix();
  for (auto& word : v) word ^= word >> 16U;
  mix();
  return (static_cast<double>(v[0] >> 8U) - 8388608.0) / 8388608.0;
}

double noise(std::uint64_t light, std::uint64_t seed, double x) {
  const double below = std::floor(x);
  const double u = x - below;
  const auto step = static_cast<std::uint64_t>(static_cast<std::int64_t>(below)) & 0xffffffffU;
  const double a = hashed(light, step, seed);
  const double b = hashed(light, (step + 1) & 0xffffffffU, seed);
  return a * (1 - 3 * u * u + 2 * u * u * u) + b * (3 * u * u - 2 * u * u * u);
}

scene::Light lightNamed(const char* name, bool shadow) {
  scene::Light light;
  light.name = name;
  light.shadow = shadow;
  return light;
}

}  // namespace

TEST_CASE("flicker: values interpolate hashes at integer times smoothly, also before time 0") {
  for (const int seed : {1, 7, 2147483647})
    for (const std::uint32_t light : {0U, 0x12345678U, 0xffffffffU})
      for (const double x : {0.0, 0.3, 17.0, 17.5, 999.25, -0.25, -3.0}) {
        CAPTURE(x);
        const auto word = static_cast<std::uint64_t>(seed);
        const double wanted = (2 * noise(light, word, x) + noise(light, word | 0x80000000U, 2.7 * x)) / 3;
        CHECK(draw::flickerNoise(light, seed, x) == doctest::Approx(wanted).epsilon(1e-12));
      }
  // The noise must have exactly these bits on every machine.
  CHECK(draw::flickerNoise(5, 1, 0.0) == -0.6277528603871664);
  CHECK(draw::flickerNoise(5, 1, 2.5) == 0.08005954697728157);
  CHECK(draw::flickerNoise(5, 1, -7.25) == -0.2712058568360887);
}

TEST_CASE(
    "flicker: it is bounded by its amount, has mean 0 and no jumps, and differs between lights and seeds") {
  scene::Flicker flicker;
  flicker.amount = 0.4F;
  flicker.sway = 0.1F;
  flicker.rate = 7;
  double sum = 0;
  double squares = 0;
  float last = draw::flickered(flicker, "torch", 3, 0).factor;
  constexpr int frames = 60000;
  for (int i = 0; i < frames; ++i) {
    const draw::Flickered now = draw::flickered(flicker, "torch", 3, i / 60.0);
    REQUIRE(std::abs(now.factor - 1) <= 0.4F);
    // The bound is the max slope of the two noises, 3 and 3 * 2.7, times the duration of a frame.
    REQUIRE(std::abs(now.factor - last) < 0.4 * (2 * 3 + 3 * 2.7) / 3 * 7 / 60 * 1.001);
    for (int axis = 0; axis < 3; ++axis) REQUIRE(std::abs(now.moved[axis]) <= 0.1F);
    sum += now.factor;
    squares += (now.factor - 1.0) * (now.factor - 1.0);
    last = now.factor;
  }
  CHECK(sum / frames == doctest::Approx(1).epsilon(0.01));
  // Uniform hashes have the variance 1/3. Smooth interpolation keeps 26/35 of it, and the sum of the two
  // noises keeps 5/9.
  CHECK(std::sqrt(squares / frames) ==
        doctest::Approx(0.4 * std::sqrt(26.0 / 35 * 5 / 9 / 3)).epsilon(0.05).scale(0));
  const auto at = [&](const char* name, int seed) {
    return draw::flickered(flicker, name, seed, 1.1).factor;
  };
  CHECK(at("torch", 3) == at("torch", 3));
  CHECK(at("torch", 3) != at("lamp", 3));
  CHECK(at("torch", 3) != at("torch", 4));
  flicker.amount = 0;
  flicker.sway = 0;
  CHECK(at("torch", 3) == 1.0F);
  CHECK(draw::flickered(flicker, "torch", 3, 1.1).moved == glm::vec3(0));
}

TEST_CASE("lamps: lamps with shadows come first, and their maps do not overlap") {
  scene::Scene scene;
  scene.lights = {lightNamed("a", false), lightNamed("b", true), lightNamed("c", false),
                  lightNamed("d", true)};
  scene.lights[1].shadowSize = 96;
  scene.lights[3].shadowSize = 33;
  scene.lights[3].shadowSoftness = 3;
  const draw::LampOrder order(scene);
  CHECK(order.shadowed == 2);
  std::string names;
  for (const scene::Light* light : order.lights) names += light->name;
  CHECK(names == "bdac");
  CHECK(order.atlas == glm::ivec2(6 * 96, 96 + 33));
  CHECK(order.rows == std::vector<int>{0, 96});
  const auto lamps = draw::lampValues(order, 1, 0, {});
  REQUIRE(lamps.size() == 4);
  CHECK(lamps[1].maps.x * 576 == doctest::Approx(33));
  CHECK(lamps[1].maps.y * 129 == doctest::Approx(33));
  CHECK(lamps[1].maps.z * 129 == doctest::Approx(96));
  // There are margins of ceil(3) + 2 texels on each side.
  CHECK(lamps[1].maps.w == doctest::Approx(23.0 / 33));
  CHECK(lamps[1].sampling.y == doctest::Approx(2.0 / 23));
}

TEST_CASE("lamps: a lamp that follows a path is placed on it, and is off without a path") {
  scene::Scene scene;
  scene.lights = {lightNamed("a", false)};
  scene::Light& light = scene.lights[0];
  light.follow.emplace();
  light.follow->object = "way";
  light.follow->progress = scene::Animated<float>({{0, 0.0F}, {4, 1.0F}}, scene::Ease::linear);
  light.follow->height = 2;
  light.follow->side = 0.5F;
  const std::string names[] = {"other", "way"};
  const std::vector<glm::vec3> elsewhere = {{9, 9, 9}, {9, 9, 8}};
  const std::vector<glm::vec3> points = {{0, 1, 0}, {8, 1, 0}};
  const draw::LampOrder order(scene);
  const sim::Drawables drawables{.paths = {{&names[0], &elsewhere}, {&names[1], &points}}};
  const shader::Lamp lamp = draw::lampValues(order, 1, 1, drawables).at(0);
  CHECK(glm::vec3(lamp.place) == glm::vec3(2, 3, 0.5F));
  CHECK(lamp.power.x > 0);
  const shader::Lamp dark = draw::lampValues(order, 1, 1, {.paths = {{&names[0], &elsewhere}}}).at(0);
  CHECK(glm::vec3(dark.power) == glm::vec3(0));
}

TEST_CASE("lamps: intensity is candela / pi, evaluated at the given time") {
  scene::Scene scene;
  scene.lights = {lightNamed("a", false)};
  scene::Light& light = scene.lights[0];
  light.color = glm::vec3(1, 0.5F, 0.25F);
  light.intensity = scene::Animated<float>({{0, 10.0F}, {2, 30.0F}}, scene::Ease::linear);
  light.radius = scene::Animated<float>({{0, 0.1F}, {2, 0.3F}}, scene::Ease::linear);
  light.position =
      scene::Animated<glm::vec3>({{0, glm::vec3(0)}, {2, glm::vec3(2, 4, 6)}}, scene::Ease::linear);
  const draw::LampOrder order(scene);
  const shader::Lamp lamp = draw::lampValues(order, 1, 1, {}).at(0);
  CHECK(lamp.place.x == doctest::Approx(1));
  CHECK(lamp.place.y == doctest::Approx(2));
  CHECK(lamp.place.z == doctest::Approx(3));
  CHECK(lamp.place.w == doctest::Approx(0.2));
  CHECK(lamp.power.x == doctest::Approx(20 / std::numbers::pi));
  CHECK(lamp.power.z == doctest::Approx(5 / std::numbers::pi));
  CHECK(lamp.power.w == doctest::Approx(25));
  light.flicker.emplace();
  light.flicker->amount = 1;
  light.flicker->sway = 2;
  const draw::Flickered unrest = draw::flickered(*light.flicker, "a", 9, 1);
  const shader::Lamp restless = draw::lampValues(order, 9, 1, {}).at(0);
  CHECK(restless.power.x == doctest::Approx(20 * unrest.factor / std::numbers::pi));
  CHECK(restless.place.y == doctest::Approx(2 + unrest.moved.y));
}

TEST_CASE("point light: inverse square outside the ball, constant inside") {
  const vec4 ball(0.3F, -1, 2, 0.25F);
  for (const double d : {0.0, 0.1, 0.2499, 0.2501, 0.7, 3.0, 400.0}) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -2, 0.5));
    const Arrival a = arrivalAt(vec3(glm::dvec3(0.3, -1, 2) + d * direction), ball, 1 / (0.25F * 0.25F));
    const double nearest = std::fmax(d, 0.25);
    CHECK(a.perArea == doctest::Approx(1 / (nearest * nearest)).epsilon(1e-4).scale(0));
    CHECK(a.spread == doctest::Approx(std::fmin(0.25 / std::fmax(d, 1e-9), 1.0)).epsilon(1e-4).scale(0));
    if (d > 0.01) CHECK(glm::dot(glm::dvec3(a.towards), direction) == doctest::Approx(-1).epsilon(1e-4));
  }
}

TEST_CASE("point light: a light of 1 candela emits 4 pi lumens through any closed surface around it") {
  const vec4 ball(0.4F, 0.2F, -0.5F, 0.05F);
  constexpr int rings = 301;
  constexpr int sectors = 403;
  double flux = 0;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sectors; ++s) {  // Samples a sphere of radius 1.3 m around the light, which is not
                                         // the light's own radius.
      const double y = 1 - 2 * (r + 0.5) / rings;
      const double turn = 2 * std::numbers::pi * (s + 0.5) / sectors;
      const double across = std::sqrt(1 - y * y);
      const glm::dvec3 normal(across * std::cos(turn), y, across * std::sin(turn));
      const Arrival a = arrivalAt(vec3(1.3 * normal), ball, 400);
      flux -= a.perArea * glm::dot(normal, glm::dvec3(a.towards));
    }
  flux *= 4 * std::numbers::pi * 1.3 * 1.3 / (rings * sectors);
  CHECK(flux == doctest::Approx(4 * std::numbers::pi).epsilon(1e-3));
}

TEST_CASE(
    "point light: a spherical light widens the lobe by half its angular size; a point light does not") {
  CHECK(widenedAlpha(0.3F, 0) == doctest::Approx(0.3));
  CHECK(widenedAlpha(0.3F, 0.8F) == doctest::Approx(0.5));
  CHECK(widenedAlpha(0, 1) == doctest::Approx(0.5));
}

TEST_CASE("lights: lumens are the integral of intensity over all directions") {
  scene::Light light;
  light.intensity = 800.0F;
  CHECK(draw::candelas(light, 0) == 800.0F);
  light.unit = scene::Light::Unit::lumen;
  CHECK(draw::candelas(light, 0) == doctest::Approx(800 / (4 * std::numbers::pi)));
  light.unit = scene::Light::Unit::watt;
  CHECK(draw::candelas(light, 0) == doctest::Approx(800 * 179 / (4 * std::numbers::pi)));
  light.unit = scene::Light::Unit::lumen;
  light.type = scene::Light::Type::spot;
  light.position = glm::vec3(0, 3, 0);
  light.spot.target = glm::vec3(0, 0, 0);
  for (const float angle : {10.0F, 45.0F, 120.0F})
    for (const float softness : {0.0F, 0.3F, 1.0F}) {
      light.spot.angle = angle;
      light.spot.softness = softness;
      scene::Scene scene;
      scene.lights = {light};
      const shader::Lamp lamp = draw::lampValues(draw::LampOrder(scene), 1, 0, {}).at(0);
      double sum = 0;
      constexpr int steps = 200000;
      for (int i = 0; i < steps; ++i) {
        const double cosine = -1 + 2 * (i + 0.5) / steps;
        const double sine = std::sqrt(1 - cosine * cosine);
        // unit vector to the light; the axis of the cone points down
        const glm::vec3 towards(sine, cosine, 0);
        sum += static_cast<double>(coneShare(towards, lamp.cone)) * 2 / steps;
      }
      CAPTURE(angle);
      CAPTURE(softness);
      CHECK(2 * std::numbers::pi * sum * static_cast<double>(draw::candelas(light, 0)) ==
            doctest::Approx(800).epsilon(0.01));
    }
}

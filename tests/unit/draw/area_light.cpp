// Tests rectangular lights by comparison with integrals in double precision. Tests lights with a limited
// range, and the cells that list these lights.
#include "draw/lights/lamp_values.hpp"
#include "draw/picture_code.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

using namespace simreel;

namespace {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
#define FUNCTION inline
#define precise
#include "glsl/draw/lights/area_light.glsl"
#include "glsl/draw/lights/range.glsl"
#undef precise
#undef FUNCTION

struct Rectangle {
  glm::dvec3 middle, across, up;
};

/// Integrates cos(receiver) cos(light) / d^2 over the front side, which is divided into many small pieces.
double integral(const Rectangle& r, glm::dvec3 p, glm::dvec3 normal, int pieces = 300) {
  const glm::dvec3 area = glm::cross(r.across, r.up) * (4.0 / (pieces * pieces));
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (int k = 0; k < pieces; ++k) {
      const glm::dvec3 at =
          r.middle + ((2 * i + 1.0) / pieces - 1) * r.across + ((2 * k + 1.0) / pieces - 1) * r.up;
      const glm::dvec3 way = at - p;
      const double d2 = glm::dot(way, way);
      const double here = glm::dot(normal, way), there = -glm::dot(area, way);
      if (here > 0 && there > 0) sum += here * there / (d2 * d2);
    }
  return sum;
}

double shareOf(const Rectangle& r, glm::dvec3 p, glm::dvec3 normal) {
  return static_cast<double>(rectangleShare(glm::vec3(p), glm::vec3(normal), glm::vec3(r.middle),
                                            glm::vec3(r.across), glm::vec3(r.up)));
}

scene::Light endingAt(const char* name, float range, glm::vec3 place) {
  scene::Light light;
  light.name = name;
  light.shadow = false;
  light.range = range;
  light.position = place;
  return light;
}

}  // namespace

TEST_CASE("area light: a plate above a plate has the tabulated form factor") {
  // Uses Howell's catalogue, C-11, four times. It gives the form factor from a differential element to a
  // parallel rectangle with one corner straight above the element.
  const double a = 0.7, b = 0.4, h = 0.9;
  const Rectangle plate{{0, h, 0}, {a, 0, 0}, {0, 0, b}};
  const double x = a / h, y = b / h;
  const double corner = (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                         y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
                        (2 * std::numbers::pi);
  // The front side faces down.
  CHECK(glm::cross(plate.across, plate.up).y < 0);
  CHECK(shareOf(plate, {0, 0, 0}, {0, 1, 0}) ==
        doctest::Approx(4 * std::numbers::pi * corner).epsilon(1e-5));
  CHECK(shareOf(plate, {0, 2, 0}, {0, -1, 0}) == 0);  // A point behind the light receives no light.
}

TEST_CASE("area light: irradiance equals the integral over the light, clipped at the horizon") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  int cut = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const glm::dvec3 across = 0.8 * glm::normalize(vector());
    const glm::dvec3 up = 0.5 * glm::normalize(glm::cross(across, vector()));
    const Rectangle r{2.0 * vector(), across, up};
    const glm::dvec3 front = glm::normalize(glm::cross(across, up));
    const glm::dvec3 p = r.middle + (0.5 + std::abs(any(random))) * front + vector();
    if (glm::dot(p - r.middle, front) < 0.2) continue;
    const glm::dvec3 normal = glm::normalize(vector());
    int below = 0;
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0})
        below += glm::dot(normal, r.middle + s * across + t * up - p) < 0 ? 1 : 0;
    cut += below > 0 && below < 4 ? 1 : 0;
    CHECK(shareOf(r, p, normal) == doctest::Approx(integral(r, p, normal)).epsilon(2e-3).scale(0.02));
  }
  CHECK(cut > 8);
}

TEST_CASE("area light: it equals a point light from far away and half of the sky close up") {
  const Rectangle r{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};  // the rectangle's front side faces +z
  const double d = 30;
  CHECK(shareOf(r, {0, 0, d}, {0, 0, -1}) == doctest::Approx(0.04 / (d * d)).epsilon(1e-3));
  CHECK(shareOf(r, {0, 0, 1e-4}, {0, 0, -1}) == doctest::Approx(std::numbers::pi).epsilon(1e-3));
}

TEST_CASE("area light: the representative point is the mirrored point, or the nearest one on the border") {
  const glm::vec3 middle(0, 2, 0), across(0.5F, 0, 0), up(0, 0, 0.25F);
  const glm::vec3 straight = towardsRectangle({0.1F, 0, 0.1F}, {0, 1, 0}, middle, across, up);
  CHECK(glm::length(straight - glm::vec3(0, 1, 0)) < 1e-6F);
  const glm::vec3 aside =
      towardsRectangle({0, 0, 0}, glm::normalize(glm::vec3(1, 1, 0)), middle, across, up);
  CHECK(glm::length(aside - glm::normalize(glm::vec3(0.5F, 2, 0))) < 1e-5F);
}

TEST_CASE(
    "area light: reflected light is within a factor of 2 of the lobe's integral over the rectangle, also "
    "at grazing angles") {
  const Rectangle r{{0, 1.6, -2}, {1.1, 0, 0}, {0, 0.9, 0}};  // the rectangle's front side faces +z
  const glm::dvec3 normal(0, 1, 0);
  double worst = 0;
  for (const double roughness : {0.35, 0.5, 0.7, 0.9})
    for (const double height : {0.25, 0.8, 2.0})
      for (const glm::dvec3 p :
           {glm::dvec3(0, 0, -0.5), glm::dvec3(0.7, 0, 0.6), glm::dvec3(-1.5, 0, 0.2)}) {
        const glm::dvec3 view = glm::normalize(glm::dvec3(0.2, height, 2.5) - p);
        constexpr int pieces = 150;
        double wanted = 0;
        for (int i = 0; i < pieces; ++i)
          for (int k = 0; k < pieces; ++k) {
            const glm::dvec3 at =
                r.middle + ((2 * i + 1.0) / pieces - 1) * r.across + ((2 * k + 1.0) / pieces - 1) * r.up;
            const glm::dvec3 way = at - p, towards = glm::normalize(way);
            const glm::dvec3 area = glm::cross(r.across, r.up) * (4.0 / (pieces * pieces));
            const double angle = -glm::dot(area, towards) / glm::dot(way, way);
            const glm::vec2 each = lobe(glm::vec3(normal), glm::vec3(view), glm::vec3(towards),
                                        static_cast<float>(roughness * roughness));
            wanted +=
                (0.04 * static_cast<double>(each.x) + static_cast<double>(each.y)) * towards.y * angle;
          }
        const glm::vec3 middle(r.middle), across(r.across), up(r.up), place(p);
        const glm::dvec3 mirrored = 2 * view.y * normal - view;
        const float lit = rectangleShare(place, glm::vec3(normal), middle, across, up);
        const glm::vec2 lobed = rectangleLobe(
            glm::vec3(normal), glm::vec3(view),
            towardsRectangle(place, glm::vec3(mirrored), middle, across, up), lit,
            static_cast<float>(roughness * roughness), rectangleSpread(place, middle, across, up));
        const double found =
            (0.04 * static_cast<double>(lobed.x) + static_cast<double>(lobed.y)) * static_cast<double>(lit);
        CAPTURE(roughness);
        CAPTURE(height);
        CAPTURE(p.x);
        if (wanted < 0.004) continue;  // Skips values that are too small to be visible.
        const double factor = found / wanted;
        worst = std::fmax(worst, std::fmax(factor, 1 / factor));
      }
  MESSAGE("at most this factor off: ", worst);
  CHECK(worst < 2);
}

TEST_CASE(
    "area light: its front faces the target, its horizontal sides are level, and lumens are emitted to one "
    "side") {
  scene::Scene scene;
  scene::Light light = endingAt("window", 0, {1, 2, 3});
  light.type = scene::Light::Type::area;
  light.area.target = glm::vec3(1, 0.5F, -1);
  light.area.width = 2.0F;
  light.area.height = 0.5F;
  light.unit = scene::Light::Unit::lumen;
  light.intensity = 100.0F;
  scene.lights = {light};
  const shader::Lamp lamp = draw::lampValues(draw::LampOrder(scene), 1, 0, {}).at(0);
  const glm::vec3 across(lamp.across), up(lamp.up);
  CHECK(glm::length(across) == doctest::Approx(1));
  CHECK(glm::length(up) == doctest::Approx(0.25));
  CHECK(across.y == 0);
  CHECK(up.y > 0);
  const glm::vec3 front = glm::normalize(glm::cross(across, up));
  CHECK(glm::length(front - glm::normalize(glm::vec3(0, -1.5F, -4))) < 1e-6F);
  CHECK(lamp.up.w == doctest::Approx(1));
  CHECK(draw::candelas(light, 0) == doctest::Approx(100 / std::numbers::pi));
}

TEST_CASE("range: attenuation is 1 nearby, 0 at the range's end, and continuous between") {
  CHECK(rangeShare(100, 0) == 1);
  CHECK(rangeShare(0.25F, 0.25F) == doctest::Approx(std::pow(1 - std::pow(0.25, 4), 2)));
  CHECK(rangeShare(1, 0.25F) == doctest::Approx(std::pow(1 - 1.0 / 16, 2)));
  CHECK(rangeShare(4, 0.25F) == 0);
  CHECK(rangeShare(9, 0.25F) == 0);
}

TEST_CASE("range: grid cells list every lamp that reaches into them") {
  scene::Scene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-5, 5);
  for (int i = 0; i < 75; ++i)
    scene.lights.push_back(endingAt(("l" + std::to_string(i)).c_str(), 0.3F + 0.02F * static_cast<float>(i),
                                    {any(random), 0.3F * any(random), any(random)}));
  scene.lights.push_back(endingAt("everywhere", 0, {0, 0, 0}));
  const draw::LampOrder order(scene);
  CHECK(order.ranged == 75);
  CHECK(order.lights.front()->name == "everywhere");
  const auto lamps = draw::lampValues(order, 1, 0, {});
  const std::vector<std::uint32_t> cells = draw::lampCells(lamps, order.ranged);
  const auto number = [&](std::size_t i) { return std::bit_cast<float>(cells[i]); };
  const glm::vec3 low(number(0), number(1), number(2)), perMetre(number(3), number(4), number(5));
  long listed = 0, reached = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 p(1.3F * any(random), 0.6F * any(random), 1.3F * any(random));
    const glm::ivec3 at(glm::floor((p - low) * perMetre));
    const bool inside = glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) &&
                        glm::all(glm::lessThan(at, glm::ivec3(16, 8, 16)));
    for (std::size_t k = 1; k < lamps.size(); ++k) {
      const bool reaches = glm::length(p - glm::vec3(lamps[k].place)) < order.lights[k]->range;
      const std::size_t cell = inside ? static_cast<std::size_t>((at.y * 16 + at.z) * 16 + at.x) : 0;
      const bool known = inside && (cells[8 + 3 * cell + (k - 1) / 32] >> ((k - 1) % 32) & 1U) != 0;
      if (reaches) CHECK(known);
      listed += known ? 1 : 0;
      reached += reaches ? 1 : 0;
    }
  }
  CHECK(reached > 1000);
  CHECK(listed < 8 * reached);  // Cells must not list many more lights than can light them.
}

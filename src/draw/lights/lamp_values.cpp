#include "draw/lights/lamp_values.hpp"

#include "base/ieee.hpp"
#include "draw/black_body.hpp"
#include "draw/lights/flicker.hpp"
#include "sim/core/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

/// Returns the position of a light, or nothing if the light follows a missing path.
std::optional<glm::vec3> placeOf(const scene::Light& light, double seconds,
                                 const sim::Drawables& drawables) {
  if (!light.follow) return light.position.at(seconds);
  const sim::Path* path = sim::pathOf(drawables, light.follow->object);
  if (path == nullptr) return std::nullopt;
  return sim::standingBy(*path->points, *light.follow, seconds).position;
}

/// Sets the atlas position and the sampling values of lamp i's six maps.
void setMaps(shader::Lamp& lamp, const LampOrder& order, std::size_t i) {
  const scene::Light& light = *order.lights[i];
  const auto side = static_cast<float>(light.shadowSize);
  const glm::vec2 atlas(order.atlas);
  // The margin keeps the filter, including its bilinear reads, within the map of one face.
  const float margin = light.type == scene::Light::Type::area
                           ? 0.125F * side
                           : std::min(std::ceil(light.shadowSoftness) + 2.0F, 0.25F * side);
  const float inner = side - 2.0F * margin;
  lamp.maps =
      glm::vec4(side / atlas.x, side / atlas.y, static_cast<float>(order.rows[i]) / atlas.y, inner / side);
  lamp.sampling = glm::vec4(lamp.place.w, 2.0F / inner, light.shadowSoftness, 1.0F / side);
}

/// Cosines of two angles from a cone's axis. edge: angle beyond which the light is 0. full: angle up to
/// which the light has full intensity.
struct Cone {
  double edge, full;
};
Cone coneAt(const scene::Spot& spot, double seconds) {
  constexpr double radiansPerDegree = std::numbers::pi / 180;
  constexpr double minimum = 1e-4;  // min difference between the two cosines
  const double half = 0.5 * radiansPerDegree * static_cast<double>(spot.angle.at(seconds));
  const double inner = half * (1 - static_cast<double>(spot.softness.at(seconds)));
  const double edge = ieee::cos(half);
  return {edge, std::max(ieee::cos(inner), edge + minimum)};
}

/// Returns the argument for coneShare() in glsl/draw/lights/point_light.glsl. For point lights, the
/// argument makes coneShare() return 1 everywhere.
glm::vec4 coneOf(const scene::Light& light, glm::vec3 place, double seconds) {
  if (light.type != scene::Light::Type::spot) return {0, 0, 0, 1};
  const auto [edge, full] = coneAt(light.spot, seconds);
  const glm::vec3 along = light.spot.target.at(seconds) - place;
  const glm::vec3 direction = glm::length(along) > 1e-6F ? glm::normalize(along) : glm::vec3(0, -1, 0);
  const auto scale = static_cast<float>(1 / (full - edge));
  return {scale * direction, static_cast<float>(-edge / (full - edge))};
}

/// Returns the ratio of a light's luminous flux to its intensity (steradians). For a cone, the ratio is 2
/// pi times the integral of the light's relative intensity over the cosine of the angle. The relative
/// intensity is 1 up to `full`. Beyond, it is the square of a linear function, with the mean 1/3.
double filledBy(const scene::Light& light, double seconds) {
  if (light.type == scene::Light::Type::area)
    return std::numbers::pi;  // a Lambertian emitter with one side has the solid angle pi
  if (light.type != scene::Light::Type::spot) return 4 * std::numbers::pi;
  const auto [edge, full] = coneAt(light.spot, seconds);
  return 2 * std::numbers::pi * ((1 - full) + (full - edge) / 3);
}

/// Sets the half vectors and the front normal of a rectangular light. The first side is horizontal. The
/// front, the cross product of the sides, faces the target.
void setRectangle(shader::Lamp& lamp, const scene::Area& area, double seconds) {
  const glm::vec3 along = area.target.at(seconds) - glm::vec3(lamp.place);
  const glm::vec3 front = glm::length(along) > 1e-6F ? glm::normalize(along) : glm::vec3(0, -1, 0);
  const bool steep = std::abs(front.y) > 0.9999F;
  const glm::vec3 across =
      glm::normalize(glm::cross(steep ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0), front));
  const float width = area.width.at(seconds), height = area.height.at(seconds);
  lamp.across = glm::vec4(0.5F * width * across, lamp.across.w);
  lamp.up = glm::vec4(0.5F * height * glm::cross(front, across), 1.0F / (width * height));
}

}  // namespace

LampOrder::LampOrder(const scene::Scene& scene) {
  for (const scene::Light& light : scene.lights)
    if (light.shadow) lights.push_back(&light);
  for (const bool ends : {false, true})
    for (const scene::Light& light : scene.lights)
      if (!light.shadow && (light.range > 0) == ends) lights.push_back(&light);
  ranged = static_cast<int>(std::ranges::count_if(
      lights, [](const scene::Light* light) { return !light->shadow && light->range > 0; }));
  for (const scene::Light* light : lights) {
    if (!light->shadow) break;
    ++shadowed;
    rows.push_back(atlas.y);
    atlas.x = std::max(atlas.x, shader::lampFaces * light->shadowSize);
    atlas.y += light->shadowSize;
  }
}

float candelas(const scene::Light& light, double seconds) {
  // Luminous efficacy of white light (lm/W) (Ward, "The RADIANCE lighting simulation and rendering system",
  // SIGGRAPH 1994).
  constexpr double lumensPerWatt = 179;
  const double given = static_cast<double>(light.intensity.at(seconds));
  switch (light.unit) {
    case scene::Light::Unit::lumen:
      return static_cast<float>(given / filledBy(light, seconds));
    case scene::Light::Unit::watt:
      return static_cast<float>(given * lumensPerWatt / filledBy(light, seconds));
    case scene::Light::Unit::candela:
      break;
  }
  return light.intensity.at(seconds);
}

std::vector<shader::Lamp> lampValues(const LampOrder& order, int seed, double seconds,
                                     const sim::Drawables& drawables) {
  constexpr float perPi = 0.31830989F;
  std::vector<shader::Lamp> lamps;
  for (std::size_t i = 0; i < order.lights.size(); ++i) {
    const scene::Light& light = *order.lights[i];
    const Flickered unrest =
        light.flicker ? flickered(*light.flicker, light.name, seed, seconds) : Flickered{};
    const float radius = light.radius.at(seconds);
    const std::optional<glm::vec3> place = placeOf(light, seconds, drawables);
    const float candela = place ? candelas(light, seconds) * unrest.factor : 0.0F;
    shader::Lamp& lamp = lamps.emplace_back();
    lamp.place = glm::vec4(place.value_or(glm::vec3(0)) + unrest.moved, radius);
    const glm::vec3 color =
        light.temperature ? blackBodyColor(*light.temperature) : light.color.at(seconds);
    lamp.power = glm::vec4(color * (candela * perPi), 1.0F / (radius * radius));
    if (light.range > 0) lamp.across.w = 1.0F / (light.range * light.range);
    if (light.type == scene::Light::Type::area) setRectangle(lamp, light.area, seconds);
    lamp.cone = coneOf(light, glm::vec3(lamp.place), seconds);
    if (light.shadow) setMaps(lamp, order, i);
  }
  return lamps;
}

void setTexels(std::vector<shader::Lamp>& lamps, const LampOrder& order) {
  for (std::size_t i = 0; i < order.rows.size(); ++i)
    lamps[i].maps = glm::vec4(order.lights[i]->shadowSize, order.atlas.x, order.rows[i], lamps[i].maps.w);
}

}  // namespace simreel::draw

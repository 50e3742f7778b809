#include "scene/stage_lamps.hpp"

#include <algorithm>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::scene {

namespace {

constexpr const char* rimName = "rim";
constexpr const char* fillName = "fill";
constexpr const char* softboxName = "softbox";
constexpr const char* cardName = "card";

/// Returns true if the scene does not give a lamp with this name, so that the stage supplies it.
bool isSuppliedByStage(const Scene& scene, const std::string& name) {
  return scene.stage.leaves("lights." + name);
}

void add(Scene& scene, const char* name, Light::Type type) {
  if (!isSuppliedByStage(scene, name) || scene.lights.size() >= maxLights) return;
  Light& lamp = scene.lights.emplace_back();
  lamp.name = name;
  lamp.type = type;
  lamp.shadow = false;
  if (type != Light::Type::area) lamp.glow = 0.0F;
}

/// Returns true if the background is so dark that polished metal has nothing to mirror.
bool isDark(const StageLook& look) {
  constexpr float dark = 0.1F;  // max luminance
  return glm::dot(glm::mix(look.zenith, look.horizon, 0.5F), glm::vec3(0.2126F, 0.7152F, 0.0722F)) < dark;
}

/// Returns true if an object of metal is drawn. Metal has no colour of its own, but mirrors its
/// surroundings.
bool hasMetal(const Scene& scene) {
  constexpr float metal = 0.5F;
  return std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
    return object.material.metallic >= metal && object.parameters->framed();
  });
}

/// Returns true if the floor is so smooth that it mirrors a lamp behind the objects as a bright spot.
bool isGlossy(const Scene& scene) {
  constexpr float glossy = 0.6F;
  return scene.ground && scene.ground->visible && scene.ground->roughness < glossy;
}

void placeRim(Light& rim, bool high, const StageLook& look, const StageSpace& space) {
  // The floor's mirror image of a high and distant lamp is below the lower edge of the picture.
  const float far = (high ? 6.0F : 3.0F) * space.radius;
  const glm::vec3 way = high ? -0.2F * space.back + 0.19F * space.right + glm::vec3(0, 1, 0)
                             : -0.8F * space.back + 0.75F * space.right + glm::vec3(0, 0.9F, 0);
  rim.position = space.middle + far * glm::normalize(way);
  rim.color = look.rimColor;
  rim.intensity = look.rim * far * far;
  rim.radius = (high ? 1.0F : 0.5F) * space.radius;
}

/// Places an area light that causes the illuminance `lux` in the centre of the stage. `way` is the vector
/// from the centre to the light, and `size` is the light's width and height. Both are in units of the
/// stage's radius.
void placeSoft(Light& lamp, const StageSpace& space, const glm::vec3& way, const glm::vec2& size,
               float lux) {
  const float far = glm::length(way) * space.radius;
  lamp.position = space.middle + space.radius * way;
  lamp.area.target = space.middle;
  lamp.area.width = size.x * space.radius;
  lamp.area.height = size.y * space.radius;
  lamp.intensity = lux * far * far;
}

}  // namespace

void addStageLamps(Scene& scene, const StageLook& look, bool soft) {
  add(scene, rimName, Light::Type::point);
  const bool ownSun = !scene.stage.leaves("sun.direction") || !scene.stage.leaves("sun.intensity");
  if (!soft || ownSun || !isDark(look) || !scene.sky.picture.empty()) return;
  add(scene, fillName, Light::Type::area);
  add(scene, softboxName, Light::Type::area);
  if (hasMetal(scene)) add(scene, cardName, Light::Type::area);
}

void moveStageLamps(Scene& scene, const StageLook& look, const StageSpace& space) {
  const bool metal = hasMetal(scene);
  for (Light& lamp : scene.lights) {
    if (!isSuppliedByStage(scene, lamp.name)) continue;
    if (lamp.name == rimName) placeRim(lamp, isGlossy(scene), look, space);
    if (lamp.name != fillName && lamp.name != softboxName && lamp.name != cardName) continue;
    lamp.color = lamp.name == cardName ? look.rimColor : look.keyColor;
    // Both lights are on the camera's side of the objects, so that the floor does not mirror them towards
    // the camera.
    // The camera looks down, so upright faces of metal mirror directions below the horizon. With metal, the
    // fill is therefore wider and lower, and a card of the rim's colour stands at the right.
    if (lamp.name == fillName)
      placeSoft(lamp, space, 1.9F * space.back + 2.2F * space.right + glm::vec3(0, metal ? 0.2F : 0.9F, 0),
                metal ? glm::vec2(3.6F, 4.4F) : glm::vec2(1.8F, 3.6F), 0.4F * look.key);
    else if (lamp.name == cardName)
      placeSoft(lamp, space, -0.4F * space.back + 2.6F * space.right + glm::vec3(0, 0.2F, 0),
                glm::vec2(3.0F, 4.4F), 0.3F * look.rim);
    else
      placeSoft(lamp, space, 0.9F * space.back - 0.9F * space.right + glm::vec3(0, 2.6F, 0),
                glm::vec2(3.6F, 2.1F), 0.25F * look.key);
  }
}

}  // namespace simreel::scene

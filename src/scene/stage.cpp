#include "scene/stage.hpp"

#include "scene/tinted.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::scene {

namespace {

/// Linear RGB, in the order of objects. Neighbouring colours differ in hue and in brightness.
constexpr std::array<glm::vec3, 8> palette = {glm::vec3(0.70F, 0.105F, 0.045F),    // vermilion
                                              glm::vec3(0.014F, 0.17F, 0.19F),     // petrol
                                              glm::vec3(0.76F, 0.37F, 0.025F),     // saffron
                                              glm::vec3(0.045F, 0.085F, 0.30F),    // ultramarine
                                              glm::vec3(0.82F, 0.74F, 0.63F),      // ivory
                                              glm::vec3(0.20F, 0.030F, 0.085F),    // plum
                                              glm::vec3(0.20F, 0.36F, 0.17F),      // sage
                                              glm::vec3(0.035F, 0.039F, 0.048F)};  // graphite

constexpr glm::vec3 flame(1.0F, 0.52F, 0.22F);  // colour of objects that shine

/// Lighting of a stage: appearance of the lit ground, background, and lamps.
struct Mood {
  glm::vec3 floor, horizon, zenith;  ///< linear radiance of the lit ground, the horizon and the zenith
  float ambient;
  glm::vec3 keyColor;
  float key;  ///< illuminance by the key light in lx
  glm::vec3 rimColor;
  float rim;   ///< illuminance by the rim light in lx, in the middle of the stage
  float most;  ///< maximum reflectance of the ground
};
constexpr Mood day{.floor = {0.62F, 0.55F, 0.47F},
                   .horizon = {0.33F, 0.32F, 0.33F},
                   .zenith = {0.28F, 0.32F, 0.40F},
                   .ambient = 0.62F,
                   .keyColor = {1.0F, 0.93F, 0.84F},
                   .key = 3.3F,
                   .rimColor = {1.0F, 0.96F, 0.92F},
                   .rim = 2.2F,
                   .most = 0.8F};
constexpr Mood night{.floor = {0.012F, 0.013F, 0.018F},
                     .horizon = {0.030F, 0.036F, 0.062F},
                     .zenith = {0.010F, 0.012F, 0.022F},
                     .ambient = 1.0F,
                     .keyColor = {0.75F, 0.85F, 1.0F},
                     .key = 0.8F,
                     .rimColor = {0.6F, 0.75F, 1.0F},
                     .rim = 0.4F,
                     .most = 0.1F};

bool anyIs(Parameters::Looks looks, const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [&](const Object& object) { return object.parameters->looks() == looks; });
}

void dress(Object& object, std::size_t number) {
  const Parameters::Looks looks = object.parameters->looks();
  const bool cloth = looks == Parameters::Looks::cloth;
  object.material.color = looks == Parameters::Looks::shining ? flame : palette.at(number % palette.size());
  object.material.roughness = cloth ? 0.7F : 0.38F;
  object.material.translucency = cloth ? 0.2F : 0.0F;
  const auto* tinted = dynamic_cast<const Tinted*>(object.parameters.get());
  const std::optional<glm::vec3> tint = tinted != nullptr ? tinted->tint() : std::nullopt;
  if (!tint) return;
  object.material.color = *tint;
  object.material.roughness = 0.7F;
  object.material.translucency = 0.3F;
}

}  // namespace

bool givesNoStage(const Node& scene) {
  return std::none_of(scene.children.begin(), scene.children.end(), [](const Node& member) {
    return member.key == "sun" || member.key == "sky" || member.key == "ground" || member.key == "lights";
  });
}

void setStage(Scene& scene, const std::vector<Framed>& framed) {
  using Looks = Parameters::Looks;
  if (framed.empty() || anyIs(Looks::landscape, scene)) return;
  scene.staged = true;
  if (!scene.render.hasQuality && scene.render.rasterizer == Rasterizer::exact)
    scene.render.quality = Quality::standard;
  scene.sun.diameter = 9.0F;
  scene.sun.shadowSize = 2048;
  scene.hasGround = true;
  // A transparent picture has no ground, because it is part of the background.
  scene.ground.visible = !scene.render.transparent;
  scene.ground.roughness = 0.9F;
  Light& rim = scene.lights.emplace_back();
  rim.name = "rim";
  rim.glow = 0.0F;
  rim.shadow = false;
  moveStage(scene, framed);
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (!scene.objects[i].hasMaterial) dress(scene.objects[i], i);
}

void moveStage(Scene& scene, const std::vector<Framed>& framed) {
  const Mood& mood = anyIs(Parameters::Looks::shining, scene) ? night : day;
  const Box box = boxAround(framed);
  const float radius = std::max(0.5F * glm::length(box.max - box.min), 1e-3F);
  const glm::vec3 middle = 0.5F * (box.min + box.max);
  const glm::vec3 back = glm::normalize(glm::vec3(1, 0, 1) * stageBack(box));
  const glm::vec3 right(back.z, 0, -back.x);

  // The key light is to the left of the camera and above it.
  const glm::vec3 key = glm::normalize(0.7F * back - 0.65F * right + glm::vec3(0, 1, 0));
  scene.sun.direction = key;
  scene.sun.color = mood.keyColor;
  scene.sun.intensity = mood.key;
  scene.sky.zenith = mood.zenith;
  scene.sky.horizon = mood.horizon;
  scene.sky.ground = mood.floor;
  scene.sky.ambient = mood.ambient;

  // The ground lies lower below a flat scene, so that it hovers a little.
  const float thin = box.max.y - box.min.y < 0.02F * radius ? 0.1F * radius : 0.0F;
  Ground& ground = scene.ground;
  ground.height = box.min.y - std::max(thin, 1e-3F * radius);
  ground.fadeStart = 2.0F * radius;
  ground.fadeEnd = 9.0F * radius;
  // With this colour, ground lit without shadow has the brightness of the background; see groundLight in
  // glsl/draw.
  const glm::vec3 fill = mood.ambient * glm::mix(mood.zenith, mood.horizon, 0.3F);
  const glm::vec3 direct = mood.keyColor * (mood.key * 0.31830989F * key.y);
  ground.color = glm::min(mood.floor / (fill + direct), glm::vec3(mood.most));

  Light& rim = scene.lights.front();
  const float far = 3.0F * radius;
  rim.position = middle + far * glm::normalize(-0.8F * back + 0.75F * right + glm::vec3(0, 0.9F, 0));
  rim.color = mood.rimColor;
  rim.intensity = mood.rim * far * far;
  rim.radius = 0.5F * radius;
}

}  // namespace simreel::scene

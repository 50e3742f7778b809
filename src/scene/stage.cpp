#include "scene/stage.hpp"

#include "base/ieee.hpp"
#include "scene/covering.hpp"
#include "scene/dressed.hpp"
#include "scene/inked.hpp"
#include "scene/stage_lamps.hpp"
#include "scene/stage_presets.hpp"
#include "scene/tinted.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::scene {

namespace {

constexpr glm::vec3 flame(1.0F, 0.52F, 0.22F);  ///< colour of objects that glow
// Luminance L of a background above which black text has more contrast than white text (WCAG 2.1). Above
// it, the contrast ratio of black, (L + 0.05) / 0.05, is greater than the ratio of white, 1.05 / (L +
// 0.05).
constexpr float inkedDark = 0.18F;
constexpr glm::vec3 darkInk(0.012F, 0.013F, 0.016F);

float luminance(const glm::vec3& color) {
  return glm::dot(color, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

bool anyIs(Parameters::Looks looks, const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [&](const Object& object) { return object.parameters->looks() == looks; });
}

/// True if a field covers this extent of the picture. A floor would hide a field behind all objects.
bool hasField(const Scene& scene, Covering::Extent extent) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    const auto* covering = dynamic_cast<const Covering*>(object.parameters.get());
    return covering != nullptr && covering->covering() == extent;
  });
}

/// Returns the look of the scene's stage, including the scene's backdrop.
StageLook lookOf(const Scene& scene) {
  StageLook look = stageLook(scene.stage.preset, anyIs(Parameters::Looks::shining, scene));
  if (scene.stage.backdrop) {
    look.floor = look.horizon = look.zenith = *scene.stage.backdrop;
    look.maximum = 1;
  }
  return look;
}

/// Returns the height for a ground with which objects collide. This is the lowest point of all objects at
/// the start. Returns infinity if the scene has only particles that fall from above.
std::optional<float> stageGroundHeight(const Scene& scene) {
  std::optional<float> lowest;
  for (const Object& object : scene.objects) {
    std::optional<float> foot = object.parameters->supportHeight();
    if (const auto box = object.parameters->framed(); box && !foot) foot = box->min.y;
    if (foot) lowest = std::min(lowest.value_or(*foot), *foot);
  }
  return lowest;
}

/// Returns the height of a floor slightly below all objects, so that no object touches it.
float floorHeight(const std::vector<Framed>& framed) {
  const Box box = boxAround(framed);
  const float radius = std::max(0.5F * glm::length(box.max - box.min), 1e-3F);
  const bool flat = box.max.y - box.min.y < 0.02F * radius;
  return box.min.y - (flat ? 0.1F : 1e-3F) * radius;
}

/// Adds those parts of the object's finish `own` to a material that the scene's material leaves out.
/// `pictured`: true if the material has an image, whose scale would also apply to the normals of `own`.
template <class Leaves>
void fillInFinish(const Material& own, const Leaves& leaves, bool pictured, Material& material) {
  Finish& finish = material.finish;
  if (leaves("roughness")) material.roughness = own.roughness;
  if (leaves("translucency")) material.translucency = own.translucency;
  if (leaves("sheen")) {
    finish.sheen = own.finish.sheen;
    if (leaves("sheenRoughness")) finish.sheenRoughness = own.finish.sheenRoughness;
  }
  if (leaves("clearCoat")) {
    finish.coat = own.finish.coat;
    if (leaves("clearCoatRoughness")) finish.coatRoughness = own.finish.coatRoughness;
  }
  if (pictured || finish.hasMaps() || !leaves("textureScale") || !leaves("bump")) return;
  finish.normals = own.finish.normals;
  if (leaves("color")) finish.color = own.finish.color;
  material.textureScale = own.textureScale;
}

/// Gives an object the colour and finish that the scene's material does not give.
void fillInMaterial(Object& object, std::size_t number, const Stage& stage, const StageLook& look) {
  Material& material = object.material;
  const auto leaves = [&](const char* key) { return !object.materialKeys.contains(key); };
  const Parameters::Looks looks = object.parameters->looks();
  const bool cloth = looks == Parameters::Looks::cloth;
  const bool clear = material.finish.transmission > 0;
  const bool pictured =
      material.skin.has_value() || !material.texture.empty() || !material.finish.color.empty();
  const auto* tinted = dynamic_cast<const HasTint*>(object.parameters.get());
  const std::optional<glm::vec3> tint = tinted != nullptr ? tinted->tint() : std::nullopt;
  const auto colors = stageColors(stage.palette == Stage::Palette::preset ? look.palette : stage.palette);
  if (leaves("color"))
    material.color = clear || pictured                     ? glm::vec3(1)
                     : tint                                ? *tint
                     : looks == Parameters::Looks::shining ? flame
                                                           : colors[number % colors.size()];
  if (leaves("roughness")) material.roughness = clear ? 0.02F : cloth || tint ? 0.7F : 0.38F;
  if (leaves("translucency")) material.translucency = tint ? 0.3F : cloth ? 0.2F : 0.0F;
  const auto* dressed = dynamic_cast<const HasFinish*>(object.parameters.get());
  if (const auto own = dressed != nullptr ? dressed->look() : std::nullopt; own && !material.skin && !clear)
    fillInFinish(*own, leaves, pictured, material);
}

/// True if the camera is below the ground at time 0. False for cameras on paths and for cameras from files.
bool isBelowGround(const Scene& scene) {
  const Camera& camera = scene.camera;
  if (!scene.ground || camera.follow || camera.gltf) return false;
  double eye = camera.position.at(0).y;
  if (camera.orbit) {
    constexpr double radian = std::numbers::pi / 180;
    eye = camera.target.at(0).y +
          camera.orbit->distance.at(0) * ieee::sin(camera.orbit->elevation.at(0) * radian);
  }
  return eye < scene.ground->height;
}

/// Gives a landscape the sky of daylight and the other objects its palette, and puts the scene's ground
/// below everything. Sun, lights and camera stay.
void openStage(Scene& scene) {
  const StageLook look = stageLook(Stage::Preset::daylight, false);
  const Stage& stage = scene.stage;
  if (scene.ground && stage.leaves("ground.height"))
    if (const std::optional<float> height = stageGroundHeight(scene); height && std::isfinite(*height))
      scene.ground->height = *height;
  if (scene.sky.picture.empty()) {
    if (stage.leaves("sky.horizon")) scene.sky.horizon = look.horizon;
    if (stage.leaves("sky.ground")) scene.sky.ground = look.horizon;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Object& object = scene.objects[i];
    if (object.parameters->looks() != Parameters::Looks::landscape) fillInMaterial(object, i, stage, look);
  }
}

}  // namespace

void Stage::describe(Fields& fields) {
  fields.choice(
      "preset", preset,
      {"false", "true", "studio", "daylight", "overcast", "sunset", "night", "void", "paper", "blueprint"},
      "Light and background. true: studio, or night for objects that glow; false: no stage.");
  fields.choice("palette", palette, {"preset", "vivid", "earth", "pastel", "grey", "ocean", "neon"},
                "Colours of objects without a \"color\". preset: as the preset has it.");
  fields.optionalValue("backdrop", backdrop, glm::vec3(0.5F), [&](glm::vec3& color) {
    fields.color("backdrop", color, notNegative, "Colour of floor and background, linear RGB.");
  });
  fields.leftOut("backdrop", "the preset's");
}

void setStage(Scene& scene, const std::vector<Framed>& framed, int version) {
  using Looks = Parameters::Looks;
  const bool landscape = anyIs(Looks::landscape, scene);
  if (landscape && scene.stage.preset == Stage::Preset::automatic) {
    if (version > 1) openStage(scene);
    return;
  }
  if (framed.empty()) return;
  const Stage& stage = scene.stage;
  const StageLook look = lookOf(scene);
  scene.staged = true;
  if (!scene.render.hasQuality && scene.render.rasterizer == Rasterizer::exact)
    scene.render.quality = Quality::standard;
  // A panorama of the sky contains a sun.
  const bool hasSun = scene.sky.picture.empty() || !stage.leaves("sun");
  if (hasSun && stage.leaves("sun.diameter")) scene.sun.diameter = look.keyDiameter;
  if (hasSun && stage.leaves("sun.shadowSize")) scene.sun.shadowSize = 2048;
  if (!scene.ground && stage.leaves("ground") && look.hasFloor && !landscape &&
      !hasField(scene, Covering::Extent::behind))
    scene.ground.emplace();
  if (scene.ground) {
    // A transparent picture has no background, and the floor counts as background.
    if (stage.leaves("ground")) scene.ground->visible = !scene.render.transparent;
    if (stage.leaves("ground.height")) {
      const bool flows = std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
        return object.parameters->supportHeight().has_value();
      });
      const std::optional<float> ground =
          stage.leaves("ground") || !flows ? std::nullopt : stageGroundHeight(scene);
      scene.ground->height = ground && std::isfinite(*ground) ? *ground : floorHeight(framed);
    }
  }
  const bool lit = std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
    return object.parameters->looks() != Looks::shining && object.parameters->framed();
  });
  addStageLamps(scene, look, version > 1 && lit);
  moveStage(scene, framed);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) fillInMaterial(scene.objects[i], i, stage, look);
  if (version == 1 || luminance(look.floor) < inkedDark) return;
  // A field over the whole picture hides the bright stage.
  if (hasField(scene, Covering::Extent::whole)) return;
  for (Object& object : scene.objects)
    if (auto* inked = dynamic_cast<HasInk*>(object.parameters.get())) inked->ink(darkInk);
}

std::string stageAdvice(const Scene& scene) {
  constexpr float bright = 0.3F;  // luminance of a background above which added light is hardly visible
  if (!scene.staged || !anyIs(Parameters::Looks::shining, scene)) return {};
  if (luminance(lookOf(scene).floor) < bright) return {};
  return "\"additive\" particles add light, which is hardly visible on a bright stage; leave out "
         "\"additive\", or take \"stage\": \"night\"";
}

void openFloor(Scene& scene) {
  if (scene.staged && scene.stage.leaves("ground") && isBelowGround(scene)) scene.ground->visible = false;
}

std::string groundAdvice(const Scene& scene) {
  if (scene.stage.leaves("ground") || !isBelowGround(scene) || !scene.ground->visible) return {};
  // If the target is also below the ground, the ground does not hide the target.
  if (!scene.camera.track && scene.camera.target.at(0).y < scene.ground->height) return {};
  return fmt::format(
      "the camera is below the ground, at {:.4g} m, which hides everything above it; move the camera up, "
      "leave out \"ground\", or give it \"visible\": false",
      scene.ground->height);
}

void moveStage(Scene& scene, const std::vector<Framed>& framed) {
  const Stage& stage = scene.stage;
  const StageLook look = lookOf(scene);
  const Box box = boxAround(framed);
  const float radius = std::max(0.5F * glm::length(box.max - box.min), 1e-3F);
  const glm::vec3 middle = 0.5F * (box.min + box.max);
  const glm::vec3 back = glm::normalize(glm::vec3(1, 0, 1) * stageBack(box));
  const glm::vec3 right(back.z, 0, -back.x);
  const auto supply = [&](const char* path, auto& value, const auto& supplied) {
    if (stage.leaves(path)) value = supplied;
  };

  const glm::vec3 key =
      glm::normalize(look.keyFrom.x * back + look.keyFrom.y * right + glm::vec3(0, look.keyFrom.z, 0));
  if (scene.sky.picture.empty() || !stage.leaves("sun")) {
    supply("sun.direction", scene.sun.direction, key);
    supply("sun.intensity", scene.sun.intensity, look.key);
    if (!scene.sun.temperature) supply("sun.color", scene.sun.color, look.keyColor);
  }
  if (scene.sky.picture.empty()) {
    supply("sky.zenith", scene.sky.zenith, look.zenith);
    supply("sky.horizon", scene.sky.horizon, look.horizon);
    supply("sky.ground", scene.sky.ground, look.floor);
    supply("sky.ambient", scene.sky.ambient, look.ambient);
  }

  if (scene.ground) {
    Ground& ground = *scene.ground;
    if (!ground.solid) ground.height = floorHeight(framed);
    supply("ground.fadeStart", ground.fadeStart, 2.0F * radius);
    supply("ground.fadeEnd", ground.fadeEnd, std::max(look.reach * radius, 1.01F * ground.fadeStart));
    if (!stage.leaves("ground.fadeEnd"))
      ground.fadeStart = std::min(ground.fadeStart, 0.5F * ground.fadeEnd);
    // The floor's colour is chosen so that the lit floor has the background's colour; see groundLight in
    // glsl/draw.
    const glm::vec3 fill = look.ambient * glm::mix(look.zenith, look.horizon, 0.3F);
    const glm::vec3 direct = look.keyColor * (look.key * 0.31830989F * key.y);
    supply("ground.color", ground.color, glm::min(look.floor / (fill + direct), glm::vec3(look.maximum)));
  }

  moveStageLamps(scene, look, {middle, radius, back, right});
}

}  // namespace simreel::scene

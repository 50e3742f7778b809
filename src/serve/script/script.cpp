#include "serve/script/script.hpp"

#include "scene/as_run.hpp"
#include "scene/load.hpp"
#include "serve/script/changes.hpp"
#include "sim/core/kind.hpp"
#include "sim/kernels/kernels.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <typeinfo>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

/// Values that draw::frameValues, draw::viewAt and the exact scene read for each picture. They do not
/// affect which shaders, textures or maps exist.
constexpr std::array<std::string_view, 23> lookPaths = {
    "camera.position",
    "camera.target",
    "camera.fieldOfView",
    "camera.roll",
    "camera.near",
    "camera.far",
    "camera.orbit",
    "camera.height",
    "sun.direction",
    "sun.color",
    "sun.temperature",
    "sun.intensity",
    "sun.shadowSoftness",
    "sky.zenith",
    "sky.horizon",
    "sky.ground",
    "sky.ambient",
    "render.exposure",
    "render.vignette",
    "ground.color",
    "title",
    "time.duration",
    "test",
};

bool isBelow(std::string_view path, std::string_view group) {
  return path == group || (path.starts_with(group) && path[group.size()] == '.');
}

bool isLook(const std::string& path) {
  return std::any_of(lookPaths.begin(), lookPaths.end(),
                     [&](std::string_view group) { return isBelow(path, group); }) ||
         isBelow(path, "checks");
}

/// Parameters of each kind of object that a running simulation can change.
constexpr std::array<std::string_view, 3> retunable = {"grayScott.feed", "grayScott.kill",
                                                       "reaction.parameters"};

using nlohmann::ordered_json;

void findDifferences(const ordered_json& before, const ordered_json& after, const std::string& path,
                     std::set<std::string>& found) {
  if (before == after) return;
  if (!before.is_object() || !after.is_object()) {
    found.insert(path);
    return;
  }
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const auto& member : before.items())
    if (!after.contains(member.key()))
      found.insert(prefix + member.key());
    else
      findDifferences(member.value(), after.at(member.key()), prefix + member.key(), found);
  for (const auto& member : after.items())
    if (!before.contains(member.key())) found.insert(prefix + member.key());
}

/// Returns the files that both scripts name and that were written between the two readings.
std::vector<std::filesystem::path> writtenFiles(const std::map<std::filesystem::path, FileStamp>& before,
                                                const std::map<std::filesystem::path, FileStamp>& after) {
  std::vector<std::filesystem::path> written;
  for (const auto& [file, stamp] : after)
    if (const auto known = before.find(file); known != before.end() && known->second != stamp)
      written.push_back(file);
  return written;
}

bool namesFile(const ordered_json& value, const std::filesystem::path& file) {
  if (value.is_string())
    return std::filesystem::path(value.get<std::string>()).filename() == file.filename();
  return value.is_structured() && std::any_of(value.begin(), value.end(), [&](const ordered_json& one) {
           return namesFile(one, file);
         });
}

/// True if a state may depend on one of the files. False if only materials, sky, camera and similar members
/// name them.
bool simulatesFrom(const std::vector<std::filesystem::path>& files, std::string_view asRun) {
  if (files.empty()) return false;
  ordered_json scene = ordered_json::parse(withoutAppearance(asRun));
  for (const char* shown : {"camera", "sky", "lights", "render", "test"}) scene.erase(shown);
  if (const auto objects = scene.find("objects"); objects != scene.end() && objects->is_object())
    for (const auto& object : objects->items())
      if (object.value().is_object()) object.value().erase("material");
  return std::any_of(files.begin(), files.end(),
                     [&](const std::filesystem::path& file) { return namesFile(scene, file); });
}

bool drawsFieldsAlone(const scene::Scene& scene) {
  return !scene.objects.empty() && !scene.render.transparent && scene.sky.picture.empty() &&
         std::all_of(scene.objects.begin(), scene.objects.end(), [](const scene::Object& object) {
           return sim::provides(object, sim::FieldSource::port);
         });
}

/// True if the scripts differ in which groups exist. Setting a member can create its group, and other parts
/// depend on whether the group exists.
bool addsGroup(const Script& before, const Script& after) {
  return before.scene.staged != after.scene.staged ||
         before.scene.ground.has_value() != after.scene.ground.has_value() ||
         before.scene.camera.follow.has_value() != after.scene.camera.follow.has_value() ||
         before.scene.camera.track.has_value() != after.scene.camera.track.has_value() ||
         before.scene.camera.gltf.has_value() != after.scene.camera.gltf.has_value() ||
         before.scene.camera.projection != after.scene.camera.projection ||
         before.scene.camera.lens.has_value() != after.scene.camera.lens.has_value() ||
         before.scene.camera.shutter.has_value() != after.scene.camera.shutter.has_value();
}

/// Returns the values of camera, light and ground that a stage derives from the objects' extents
/// (scene::setStage, frameObjects).
auto standing(const scene::Scene& scene) {
  const scene::Camera& camera = scene.camera;
  const scene::Ground ground = scene.ground.value_or(scene::Ground());
  return std::tuple(camera.position.at(0), camera.target.at(0),
                    camera.orbit.value_or(scene::Orbit()).distance.at(0), camera.fieldOfView.at(0),
                    camera.height.at(0), camera.near, camera.far, scene.sun.direction.at(0),
                    scene.sun.color.at(0), scene.sun.intensity.at(0), scene.sky.zenith.at(0),
                    scene.sky.horizon.at(0), scene.sky.ground.at(0), scene.sky.ambient.at(0), ground.height,
                    ground.fadeStart, ground.fadeEnd, ground.color);
}

bool standsAlike(const scene::Light& a, const scene::Light& b) {
  return a.position.at(0) == b.position.at(0) && a.color.at(0) == b.color.at(0) &&
         a.intensity.at(0) == b.intensity.at(0) && a.radius.at(0) == b.radius.at(0);
}

/// True if two objects have the same name, kind, colour, roughness and translucency. A stage may derive the
/// last three from the scene.
bool dressedAlike(const scene::Object& a, const scene::Object& b) {
  const scene::Parameters &one = *a.parameters, &other = *b.parameters;
  return a.name == b.name && a.kind == b.kind && typeid(one) == typeid(other) &&
         a.material.color == b.material.color && a.material.roughness == b.material.roughness &&
         a.material.translucency == b.material.translucency;
}

/// True if two scenes have equal derived values. Derived values are not given by the scene but computed
/// from the objects.
bool impliesAlike(const scene::Scene& before, const scene::Scene& after) {
  const auto alike = [](const auto& a, const auto& b, const auto& equal) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
  };
  return standing(before) == standing(after) && alike(before.lights, after.lights, standsAlike) &&
         alike(before.objects, after.objects, dressedAlike);
}

void takeLookOf(scene::Scene& shown, scene::Scene& from) {
  const scene::Camera before = shown.camera;
  shown.camera = from.camera;
  // `shown` may be a draft, which has no lens and no shutter. It must not get the lens and shutter of
  // `from`.
  if (!before.lens) shown.camera.lens.reset();
  if (!before.shutter) shown.camera.shutter.reset();
  shown.sun.direction = from.sun.direction;
  shown.sun.color = from.sun.color;
  shown.sun.temperature = from.sun.temperature;
  shown.sun.intensity = from.sun.intensity;
  shown.sun.shadowSoftness = from.sun.shadowSoftness;
  shown.sky.zenith = from.sky.zenith;
  shown.sky.horizon = from.sky.horizon;
  shown.sky.ground = from.sky.ground;
  shown.sky.ambient = from.sky.ambient;
  shown.render.exposure = from.render.exposure;
  shown.render.vignette = from.render.vignette;
  if (shown.ground && from.ground) shown.ground->color = from.ground->color;
  shown.title = from.title;
  shown.time.duration = from.time.duration;
  shown.test = from.test;
  shown.checks = from.checks;
}

}  // namespace

std::shared_ptr<Script> readScript(const SceneSource& source, const std::string& text,
                                   std::vector<scene::Override> edits) {
  auto script = std::make_shared<Script>();
  std::vector<scene::Override> all = source.given;
  all.insert(all.end(), edits.begin(), edits.end());
  script->text = text;
  script->edits = std::move(edits);
  script->scene = scene::parseScene(text, source.file, all, sim::kinds(), source.folders);
  script->draft = scene::parseScene(text, source.file, all, sim::kinds(), source.folders);
  script->draft.camera.lens.reset();
  script->draft.camera.shutter.reset();
  constexpr int draftShadow = 512;
  script->draft.sun.shadowSize = std::min(script->draft.sun.shadowSize, draftShadow);
  if (script->draft.render.quality == scene::Quality::high)
    script->draft.render.quality = scene::Quality::draft;
  script->asRun = scene::textAsRun(text, source.file, all);
  script->simulation = scene::simulationHash(withoutAppearance(script->asRun));
  for (const std::filesystem::path& file : sim::shaderFiles(script->scene)) {
    auto& files = script->scene.files;
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  }
  for (const std::filesystem::path& file : script->scene.files) script->files[file] = stampOf(file);
  script->fieldsAlone = drawsFieldsAlone(script->scene);
  // On devices with the texel memory path, the GL driver's rasterizer draws the draft (Stage::drawerOf). It
  // needs these settings.
  if (script->fieldsAlone) {
    script->draft.sun.diameter = 0;
    script->draft.render.quality = scene::Quality::draft;
  }
  return script;
}

void placeCamera(Script& script, const Script* known, bool moving) {
  if (!sim::needsSurvey(script.scene) && !sim::needsRanges(script.scene)) return;
  const std::string wanted = script.simulation + " " + std::to_string(script.scene.frameCount());
  const bool same =
      known != nullptr && known->surveyOf == wanted && writtenFiles(known->files, script.files).empty();
  const bool measured = known != nullptr && sim::coversRanges(known->survey, script.scene);
  if (measured && (same || (moving && !known->surveyOf.empty()))) {
    script.survey = known->survey;
    script.surveyOf = known->surveyOf;
  } else {
    script.survey = sim::surveyMotion(script.scene);
    script.surveyOf = wanted;
  }
  sim::frameSurvey(script.scene, script.survey);
  sim::frameSurvey(script.draft, script.survey);
}

bool framedAlike(const Script& before, const Script& after) {
  const scene::Camera& a = before.scene.camera;
  const scene::Camera& b = after.scene.camera;
  return before.survey.frames == 0 && after.survey.frames == 0
             ? true
             : a.position.at(0) == b.position.at(0) && a.target.at(0) == b.target.at(0) &&
                   a.orbit.value_or(scene::Orbit()).distance.at(0) ==
                       b.orbit.value_or(scene::Orbit()).distance.at(0) &&
                   before.scene.ground.value_or(scene::Ground()).height ==
                       after.scene.ground.value_or(scene::Ground()).height;
}

std::set<std::string> differingPaths(std::string_view before, std::string_view after) {
  std::set<std::string> found;
  findDifferences(ordered_json::parse(before), ordered_json::parse(after), "", found);
  return found;
}

Change changeBetween(const Script& before, const Script& after) {
  if (before.simulation != after.simulation) return Change::simulation;
  if (const auto written = writtenFiles(before.files, after.files); !written.empty())
    return simulatesFrom(written, after.asRun) ? Change::simulation : Change::dress;
  const std::set<std::string> paths = differingPaths(before.asRun, after.asRun);
  if (paths.empty()) return Change::nothing;
  if (before.scene.staged != after.scene.staged) return Change::dress;
  for (const std::string& path : paths)
    if (isBelow(path, "objects") || isBelow(path, "lights")) return Change::dress;
  if (addsGroup(before, after)) return Change::drawing;
  // An absent group may have values from another source, such as a sky panorama or a stage.
  const bool whole = std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
    return path == "sun" || path == "sky" || path == "ground" || path == "render" || path == "time";
  });
  const bool look = std::all_of(paths.begin(), paths.end(),
                                [](const std::string& path) { return path == "camera" || isLook(path); });
  return look && !whole ? Change::look : Change::drawing;
}

bool drawsAlike(const Script& before, const Script& after) {
  if (before.scene.staged != after.scene.staged || addsGroup(before, after)) return false;
  if (!impliesAlike(before.scene, after.scene)) return false;
  if (!writtenFiles(before.files, after.files).empty()) return false;
  const std::set<std::string> paths = differingPaths(before.asRun, after.asRun);
  return std::all_of(paths.begin(), paths.end(), [](const std::string& path) {
    return path.starts_with("objects.") && scene::touchesSimulation(path);
  });
}

int firstOther(const Simulated& before, const Script& after) {
  if (simulatesFrom(writtenFiles(before.files, after.files), after.asRun)) return 0;
  if (before.simulation == after.simulation) return farFrame;
  const double seconds = equalUntil(before.asRun, after.asRun);
  // The state of a frame depends on what happens before its time, not on what happens exactly at its time.
  constexpr double rounding = 1e-9;
  const double frames = std::floor(seconds * after.scene.time.fps + rounding);
  return static_cast<int>(std::clamp(frames, 0.0, static_cast<double>(farFrame)));
}

std::vector<std::size_t> retunedObjects(const Script& before, const Script& after) {
  const std::set<std::string> paths = differingPaths(before.asRun, after.asRun);
  if (!writtenFiles(before.files, after.files).empty()) return {};
  std::set<std::size_t> objects;
  for (const std::string& path : paths) {
    bool known = false;
    for (std::size_t i = 0; i < after.scene.objects.size() && !known; ++i) {
      const std::string place = "objects." + after.scene.objects[i].name + ".";
      known = path.starts_with(place) &&
              std::any_of(retunable.begin(), retunable.end(), [&](std::string_view value) {
                return isBelow(std::string_view(path).substr(place.size()), value);
              });
      if (known) objects.insert(i);
    }
    if (!known) return {};
  }
  return {objects.begin(), objects.end()};
}

void takeLook(Script& shown, Script& from) {
  takeLookOf(shown.scene, from.scene);
  takeLookOf(shown.draft, from.draft);
  shown.scene.hash = from.scene.hash;
  shown.scene.overrides = from.scene.overrides;
  shown.text = from.text;
  shown.edits = from.edits;
  shown.asRun = from.asRun;
}

std::vector<scene::Override> withEdit(std::span<const scene::Override> edits,
                                      const scene::Override& change) {
  std::vector<scene::Override> result;
  for (const scene::Override& edit : edits)
    if (!isBelow(edit.path, change.path)) result.push_back(edit);
  result.push_back(change);
  return result;
}

}  // namespace simreel::serve

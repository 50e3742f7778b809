#include "scene/load.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "scene/fitted.hpp"
#include "scene/framing.hpp"
#include "scene/haze_reach.hpp"
#include "scene/hidden.hpp"
#include "scene/idle_keys.hpp"
#include "scene/json/json_node.hpp"
#include "scene/json/scene_error.hpp"
#include "scene/json/words.hpp"
#include "scene/objects.hpp"
#include "scene/override.hpp"
#include "scene/panels.hpp"
#include "scene/picture_area.hpp"
#include "scene/scene_source.hpp"
#include "scene/sections.hpp"
#include "scene/stage.hpp"
#include "scene/value/asset_path.hpp"
#include "scene/value/reader.hpp"
#include "scene/value/value_reader.hpp"
#include "scene/warm.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Returns the scene's version. Reports an error and returns nullopt if this program cannot read that
/// version. Reports an error but returns a version if the scene does not give one.
std::optional<int> versionOf(const Node* version, const Node& root, Diagnostics& diagnostics) {
  if (version == nullptr) {
    diagnostics.add(root.headPlace(),
                    fmt::format("the scene has no version; add \"version\": {}", sceneVersion));
    return sceneVersion;
  }
  const auto number = ValueReader("version", diagnostics).integer(*version);
  if (!number) return sceneVersion;
  if (*number >= oldestSceneVersion && *number <= sceneVersion) return static_cast<int>(*number);
  diagnostics.add(version->place(), fmt::format("unknown version {}; this program reads versions {} to {}",
                                                *number, oldestSceneVersion, sceneVersion));
  return std::nullopt;
}

/// Source files of a scene's text and its sidecar's text.
struct Sources {
  std::string file;
  std::string sidecar;    ///< path of the sidecar, which need not exist
  int sidecarNumber = 0;  ///< source number of the sidecar's text; 0 if no sidecar was read
};

/// Returns the origin of each bound in test.tolerance. The origin is the file that contains the bound, or
/// "-D".
std::map<std::string, std::string> toleranceOrigin(const Node& root, const Sources& sources) {
  std::map<std::string, std::string> origins;
  const Node* test = root.find("test");
  const Node* tolerance = test == nullptr ? nullptr : test->find("tolerance");
  if (tolerance == nullptr) return origins;
  for (const Bound& bound : Tolerance().bounds()) {
    const Node* given = tolerance->find(bound.name);
    if (given == nullptr) given = tolerance->find(bound.formerName());
    if (given == nullptr) continue;
    origins[bound.name] = given->source == 0                       ? sources.file
                          : given->source == sources.sidecarNumber ? sources.sidecar
                                                                   : "-D";
  }
  return origins;
}

/// Replaces the scene's "test" and "checks" with the members of the sidecar.
void applySidecar(Node& root, Node sidecar, ReadContext context) {
  if (!ValueReader("", context.diagnostics).expect(sidecar, Node::Kind::object, "an object")) return;
  Reader fields(&sidecar, sidecar.headPlace(), context);
  for (const char* name : {"test", "checks"}) static_cast<void>(fields.consume(name));
  fields.finish();
  if (root.kind != Node::Kind::object) return;
  for (Node& member : sidecar.children) {
    if (member.key != "test" && member.key != "checks") continue;
    Node* own = root.find(member.key);
    if (own != nullptr)
      *own = std::move(member);
    else
      root.children.push_back(std::move(member));
  }
}

bool changesTime(std::span<const Override> overrides) {
  return std::any_of(overrides.begin(), overrides.end(), [](const Override& change) {
    return change.path == "time" || change.path.starts_with("time.");
  });
}

/// Reads the glTF file of the scene's camera. Takes the angle of view and the near and far distance from
/// the file if the scene does not give them.
void openCamera(const Node& root, ReadContext context, const Kinds& kinds, Camera& camera) {
  const Node* section = root.find("camera");
  const Node* group = section == nullptr ? nullptr : section->find("gltf");
  if (!camera.gltf || group == nullptr || !kinds.openCamera) return;
  CameraFile& gltf = *camera.gltf;
  try {
    gltf.shot = kinds.openCamera(gltf);
  } catch (const UserError& error) {
    if (error.code() != ExitCode::usage) throw;
    context.diagnostics.add(group->place(), error.what());
    return;
  }
  const Node* wrong = nullptr;  // member that has no effect for the file's type of camera
  if (const std::optional<double> height = gltf.shot->height()) {
    camera.projection = Projection::orthographic;
    if (!camera.hasHeight) camera.height = static_cast<float>(*height);
    if (camera.lens) wrong = section->find("lens");
    if (camera.hasAngle) wrong = section->find("fieldOfView");
  } else {
    if (!camera.hasAngle) camera.fieldOfView = static_cast<float>(gltf.shot->fieldOfView());
    if (camera.hasHeight) wrong = section->find("height");
  }
  if (wrong != nullptr)
    context.diagnostics.add(
        wrong->place(),
        fmt::format("the file's camera is {}, which has no \"{}\"; leave it out",
                    camera.projection == Projection::orthographic ? "orthographic" : "a perspective one",
                    wrong->key));
  if (!gltf.hasNear) camera.near = static_cast<float>(gltf.shot->near());
  if (!gltf.hasFar && gltf.shot->far()) camera.far = static_cast<float>(*gltf.shot->far());
  if (camera.near < camera.far) return;
  context.diagnostics.add(group->place(),
                          fmt::format("with its file's camera \"near\" is {} m and \"far\" {} m; give both",
                                      camera.near, camera.far));
}

/// Checks that an object with the name in `group` ("track" or "follow") of `owner` exists. The group may be
/// an object or, as a shorthand, the name itself. "track" rejects objects that are drawn over the picture,
/// because they have no position in the world.
void checkObjectNamed(const Node* owner, const char* group, const std::string& name, const char* kind,
                      const std::vector<Object>& objects, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  names.reserve(objects.size());
  for (const Object& object : objects) names.push_back(object.name);
  const auto found = std::find(names.begin(), names.end(), name);
  const Parameters* const parameters =
      found == names.end() ? nullptr
                           : objects[static_cast<std::size_t>(found - names.begin())].parameters.get();
  const char* const drawnWith = parameters == nullptr ? nullptr : parameters->drawnWith();
  if (found != names.end() && (drawnWith == nullptr || std::string_view(group) != "track")) return;
  const Node* given = owner == nullptr ? nullptr : owner->find(group);
  if (given == nullptr || diagnostics.anyWithin(given->place())) return;
  const Node* named = given->kind == Node::Kind::object ? given->find("object") : given;
  const Place place = named == nullptr ? given->headPlace() : named->place();
  if (drawnWith != nullptr)
    return diagnostics.add(
        place, fmt::format("object \"{}\" is drawn over the picture and has no place in the world", name));
  diagnostics.add(place, fmt::format("no object is named {}; {}", inQuotes(name),
                                     names.empty() ? fmt::format("the scene has none: add {}", kind)
                                                   : suggestion(name, names)));
}

/// Checks the object names that the camera and the lights refer to.
void checkFollowed(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  const Node* camera = root.find("camera");
  if (scene.camera.track)
    checkObjectNamed(camera, "track", scene.camera.track->object, "one", scene.objects, diagnostics);
  if (scene.camera.follow)
    checkObjectNamed(camera, "follow", scene.camera.follow->object, "a cave", scene.objects, diagnostics);
  checkShown(root, scene, diagnostics);
  const Node* lights = root.find("lights");
  for (const Light& light : scene.lights)
    if (light.follow && lights != nullptr)
      checkObjectNamed(lights->find(light.name), "follow", light.follow->object, "a cave", scene.objects,
                       diagnostics);
}

/// Records which members of sun, sky, ground and lights the scene gives.
void noteSurroundings(const Node& root, Stage& stage) {
  for (const char* name : {"sun", "sky", "ground", "lights"}) {
    const Node* section = root.find(name);
    if (section == nullptr) continue;
    stage.given.emplace(name);
    for (const Node& member : section->children) stage.given.insert(fmt::format("{}.{}", name, member.key));
  }
}

/// Leaves out the tone curve, so that a field behind all objects has the colours of its colour bar, which
/// is drawn over the finished picture. Does nothing if the scene gives the curve.
void keepBarColors(const Node& root, Scene& scene) {
  const Node* render = root.find("render");
  if (render != nullptr && render->find("tone") != nullptr) return;
  if (explainsBehind(root, scene)) scene.render.tone = Tone::plain;
}

/// Reads a scene from its JSON tree. `heldToLength`: true if test frames after the scene's end are errors.
void readScene(const Node& root, ReadContext context, const Kinds& kinds, bool heldToLength, Scene& scene) {
  if (!ValueReader("", context.diagnostics).expect(root, Node::Kind::object, "a scene in { }")) return;
  const Node* versionNode = root.find("version");
  // In another version, the other members may have other meanings.
  const std::optional<int> version = versionOf(versionNode, root, context.diagnostics);
  if (!version) return;
  context.version = *version;
  Reader fields(&root, root.headPlace(), context);
  static_cast<void>(fields.consume("version"));  // The version has been read above.
  const std::size_t errorsBefore = context.diagnostics.count();
  describeScene(fields, scene);
  // The length of a scene with errors is not reliable. In that case test frames are not checked against it.
  const bool lengthKnown = heldToLength && context.diagnostics.count() == errorsBefore;
  const Node* objects = fields.consume("objects");
  const bool hasGround = scene.ground && scene.ground->solid;
  if (objects != nullptr) readObjects(*objects, context, kinds, hasGround, scene.objects);
  // Unknown object names are reported even if the scene has other errors.
  const bool namesKnown = objects == nullptr || (objects->kind == Node::Kind::object &&
                                                 objects->children.size() == scene.objects.size());
  if (*version > 1 && context.diagnostics.count() == errorsBefore)
    for (Object& object : scene.objects)
      if (auto* fitted = dynamic_cast<Fitted*>(object.parameters.get()))
        fitted->fitPicture(viewSize(scene));
  if (context.diagnostics.count() == errorsBefore) {
    makeRoom(scene);
    moveAside(scene);
  }
  const Node* time = root.find("time");
  if (*version > 1 && context.diagnostics.count() == errorsBefore &&
      (time == nullptr || time->find("start") == nullptr))
    scene.time.start = warmUpOf(scene);
  if (namesKnown) checkFollowed(root, scene, context.diagnostics);
  if (context.diagnostics.count() == 0) openCamera(root, context, kinds, scene.camera);
  if (context.diagnostics.count() == 0) {
    noteSurroundings(root, scene.stage);
    const bool staged = scene.stage.preset != Stage::Preset::none;
    // Computing extents may read mesh files and subdivide meshes, so it is skipped unless the extents are
    // needed.
    std::vector<Framed> framed;
    if (*version > 1) setApart(scene);
    if (*version > 1) keepBarColors(root, scene);
    if (staged || !scene.camera.placed) framed = framedObjects(scene);
    if (staged) setStage(scene, framed, *version);
    if (const std::string advice = stageAdvice(scene); !advice.empty())
      context.diagnostics.remark(
          root.find("stage") != nullptr ? root.find("stage")->headPlace() : root.headPlace(), advice);
    frameObjects(scene, framed);
    openFloor(scene);
    extendGroundIntoHaze(scene);
    const Node* camera = root.find("camera");
    if (camera == nullptr || camera->find("far") == nullptr) extendViewIntoHaze(scene);
    warnHidden(root, scene, context.diagnostics);
    warnIdleKeys(root, scene, context.diagnostics);
  }
  fields.idleUnless(scene.render.quality == Quality::standard, "render.quality", {"render.occlusionRadius"},
                    "\"quality\": \"standard\"");
  describeTests(fields, scene, lengthKnown ? std::optional(scene.frameCount()) : std::nullopt);
  std::string schemaAddress;  // Address of the schema. Only text editors use it.
  fields.text("$schema", schemaAddress, "");
  fields.finish();
}

/// Inputs for reading a scene, in addition to the scene's text.
struct LoadInputs {
  std::span<const Override> overrides;
  const Kinds& kinds;
  std::span<const std::filesystem::path> folders;
};

/// Returns a hash of a file's bytes, or an empty string for a file that cannot be read. The file's reader
/// reports the error.
std::string contentHash(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  try {
    return hashHex(readFile(file, "file"));
  } catch (const UserError&) {
    return {};
  }
}

/// Reads a scene from its text. `sidecar`: text of the sidecar; null if the file does not exist or is not
/// needed.
Scene parse(std::string_view text, const std::filesystem::path& file, const std::string* sidecar,
            const LoadInputs& with, bool heldToLength) {
  Sources sources{file.string(), sidecarOf(file).string(), 0};
  Diagnostics diagnostics(sources.file, text);
  const AssetFolders assets(file, with.folders, assetFolder());
  Scene scene;
  std::optional<Node> root = parseJson(text, 0, 0, diagnostics);
  if (root) {
    if (sidecar != nullptr) {
      sources.sidecarNumber = diagnostics.addFile(sources.sidecar, *sidecar);
      if (std::optional<Node> beside = parseJson(*sidecar, sources.sidecarNumber, 0, diagnostics))
        applySidecar(*root, std::move(*beside), {diagnostics, assets});
    }
    for (const Override& change : with.overrides) applyOverride(*root, change, diagnostics);
    readScene(*root, {diagnostics, assets}, with.kinds, heldToLength, scene);
    scene.test.toleranceOrigin = toleranceOrigin(*root, sources);
  }
  if (!diagnostics.empty()) throw SceneError(diagnostics, root ? &*root : nullptr);

  scene.remarks = diagnostics.remarks();
  scene.files.assign(assets.found().begin(), assets.found().end());
  std::string hashed(text);
  for (const Override& change : with.overrides) {
    scene.overrides.push_back(change.path + "=" + change.value);
    hashed += "\n" + scene.overrides.back();
  }
  for (const std::filesystem::path& named : scene.files) scene.filesHash += contentHash(named);
  hashed += scene.filesHash.empty() ? "" : "\n" + scene.filesHash;
  scene.hash = hashHex(hashed);
  return scene;
}

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& file,
                 std::span<const Override> overrides, const Kinds& kinds,
                 std::span<const std::filesystem::path> folders) {
  // An override may shorten the scene. In that case test frames after the new end are not errors, because
  // no test runs.
  return parse(text, file, nullptr, {overrides, kinds, folders}, !changesTime(overrides));
}

Scene loadScene(const std::filesystem::path& file, std::span<const Override> overrides, const Kinds& kinds,
                std::span<const std::filesystem::path> folders) {
  const auto [text, name] = readSceneSource(file, kinds);
  return parseScene(text, name, overrides, kinds, folders);
}

std::filesystem::path sidecarOf(const std::filesystem::path& sceneFile) {
  return std::filesystem::path(sceneFile).replace_extension(".test.json");
}

Scene loadTestScene(const std::filesystem::path& file, std::span<const Override> overrides,
                    const Kinds& kinds, std::span<const std::filesystem::path> folders) {
  const auto [text, name] = readSceneSource(file, kinds);
  const LoadInputs with{overrides, kinds, folders};
  const std::filesystem::path beside = sidecarOf(file);
  if (file == "-" || !pathExists(beside)) return parse(text, name, nullptr, with, true);
  const std::string sidecar = readFile(beside, "test settings", maxSceneBytes);
  return parse(text, name, &sidecar, with, true);
}

}  // namespace simreel::scene

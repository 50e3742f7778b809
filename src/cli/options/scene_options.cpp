#include "cli/options/scene_options.hpp"

#include "base/error.hpp"
#include "base/text.hpp"
#include "cli/options/shipped_scene.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

namespace simreel::cli {

namespace {

/// Returns a size as JSON: "1280x720" -> "[1280,720]".
std::string sizeValue(const std::string& text) {
  const auto size = integerPair(text, 'x');
  if (!size || size->first < 1 || size->second < 1)
    fail(ExitCode::usage, "--size takes WxH, for example 1280x720, not \"{}\"", text);
  return fmt::format("[{},{}]", size->first, size->second);
}

}  // namespace

std::vector<scene::Override> parseOverrides(const std::vector<std::string>& texts) {
  std::vector<scene::Override> result;
  result.reserve(texts.size());
  for (const std::string& text : texts) result.push_back(scene::parseOverride(text));
  return result;
}

void addAssets(CLI::App& command, std::vector<std::string>& folders) {
  command
      .add_option("--assets", folders,
                  "Folder where scenes may find files, besides their own folder and the shipped assets; "
                  "repeatable")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
}

std::vector<std::filesystem::path> assetFolders(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders)
    if (std::error_code error; !std::filesystem::is_directory(folder, error))
      fail(ExitCode::usage, "--assets {}: there is no such folder", folder);
  return {folders.begin(), folders.end()};
}

void SceneOptions::add(CLI::App& command) {
  addOptional(command);
  command.get_option("scene")->required();
}

void SceneOptions::addOptional(CLI::App& command) {
  findShipped(*command.add_option("scene", file,
                                  "Scene file, name of a shipped scene (flag), or - for standard input"),
              &shipped);
  command
      .add_option("-D", overrides,
                  "Override any value of the scene, for example -D camera.fieldOfView=30; repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", seed, "Seed of all random numbers");
  command.add_option("--size", size, "Picture size in pixels, for example 1280x720")->type_name("WxH");
  command.add_option("--fps", fps, "Frames per second of scene time");
  command
      .add_option(
          "--turn", turn,
          "Turntable: the camera goes once round the scene in this many seconds, which become its length")
      ->type_name("SECONDS");
  command.add_option("--samples", samples, "Samples per pixel");
  command
      .add_option("--rasterizer", rasterizer,
                  "exact draws the same pixels on every machine; driver uses the GPU's own rasterizer "
                  "(default: as the scene says)")
      ->type_name("exact|driver");
  command
      .add_option("--overlay", overlay,
                  "Show a property of surfaces instead of light; `simreel list render` explains each")
      ->check(CLI::IsMember({"none", "wireframe", "normals", "uv", "objects"}));
  addAssets(command, assets);
}

/// Replaces the position of a scene's camera by an orbit that starts at that position. Returns the angle at
/// which the orbit starts, in degrees.
double SceneOptions::addOrbit(std::vector<scene::Override>& changes) const {
  if (file == "-") return 0;  // Standard input can be read only once.
  const scene::Camera camera = scene::loadScene(file, changes, sim::kinds(), assetFolders(assets)).camera;
  if (!camera.placed || camera.orbit || camera.follow || camera.track || camera.gltf) return 0;
  constexpr double degrees = 180 / std::numbers::pi;
  const glm::dvec3 way = glm::dvec3(camera.position.at(0)) - glm::dvec3(camera.target.at(0));
  const double distance = glm::length(way);
  if (!(distance > 0)) return 0;
  changes.push_back({"camera.position", "null"});
  changes.push_back({"camera.target", fmt::format("[{}, {}, {}]", camera.target.at(0).x,
                                                  camera.target.at(0).y, camera.target.at(0).z)});
  changes.push_back({"camera.orbit.distance", fmt::format("{}", distance)});
  changes.push_back({"camera.orbit.elevation",
                     fmt::format("{}", std::clamp(std::asin(way.y / distance) * degrees, -89.0, 89.0))});
  return std::atan2(way.x, way.z) * degrees;
}

std::vector<scene::Override> SceneOptions::changes() const {
  auto all = parseOverrides(overrides);
  if (seed) all.push_back({"seed", std::to_string(*seed)});
  if (size) all.push_back({"render.size", sizeValue(*size)});
  if (fps) all.push_back({"time.fps", fmt::format("{}", *fps)});
  if (turn) {
    if (!(*turn > 0)) fail(ExitCode::usage, "--turn takes seconds above 0, not {}", *turn);
    const double from = addOrbit(all);
    all.push_back({"time.duration", fmt::format("{}", *turn)});
    all.push_back(
        {"camera.orbit.turn", fmt::format(R"({{"keys": [[0, {}], [{}, {}]]}})", from, *turn, from + 360)});
  }
  if (samples) all.push_back({"render.samples", std::to_string(*samples)});
  if (rasterizer) all.push_back({"render.rasterizer", *rasterizer});
  if (overlay) all.push_back({"render.overlay", *overlay});
  return all;
}

scene::Scene SceneOptions::load(const std::vector<scene::Override>& more) const {
  auto all = changes();
  all.insert(all.end(), more.begin(), more.end());
  return scene::loadScene(file, all, sim::kinds(), assetFolders(assets));
}

std::vector<std::string> SceneOptions::arguments() const {
  std::vector<std::string> words = {file};
  for (const std::string& change : overrides) words.insert(words.end(), {"-D", change});
  if (seed) words.push_back(fmt::format("--seed={}", *seed));
  if (size) words.push_back(fmt::format("--size={}", *size));
  if (fps) words.push_back(fmt::format("--fps={}", *fps));
  if (turn) words.push_back(fmt::format("--turn={}", *turn));
  if (samples) words.push_back(fmt::format("--samples={}", *samples));
  if (rasterizer) words.push_back("--rasterizer=" + *rasterizer);
  if (overlay) words.push_back("--overlay=" + *overlay);
  for (const std::string& folder : assets) words.push_back("--assets=" + folder);
  return words;
}

}  // namespace simreel::cli

#include "golden/suite/scene_set.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <fnmatch.h>
#include <map>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

bool isSceneName(const fs::path& file) {
  const std::string name = file.filename().string();
  return file.extension() == ".json" && !name.starts_with('.') && !name.ends_with(".test.json");
}

/// True if the file may be a scene. Invalid JSON counts as a scene, so that its mistake is reported and the
/// file is not skipped.
bool mayBeScene(const fs::path& file) {
  const std::string text = readFile(file, "scene");
  try {
    const auto json = parseStrictJson(text, {.comments = true});
    return json.is_object() && (json.contains("version") || json.contains("objects"));
  } catch (const JsonError&) {
    return true;
  }
}

void searchFolder(const fs::path& folder, std::vector<SceneFile>& found) {
  std::error_code error;
  fs::recursive_directory_iterator entries(folder, error);
  for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
    const fs::path path = entries->path();
    const std::string name = path.filename().string();
    if (entries->is_directory()) {
      if (name.starts_with('.') || name == "golden") entries.disable_recursion_pending();
      continue;
    }
    if (isSceneName(path) && entries->is_regular_file() && mayBeScene(path))
      found.push_back({path.lexically_relative(folder).replace_extension().generic_string(), path});
  }
  if (error) fail(ExitCode::inputOutput, "cannot read folder {}: {}", folder.string(), error.message());
}

/// Converts a path to a name that is unique regardless of the folder. Removes the root and replaces ".." by
/// "up".
std::string wholeName(const fs::path& file) {
  fs::path name;
  for (const fs::path& part : file.lexically_normal().replace_extension().relative_path())
    name /= part == ".." ? fs::path("up") : part;
  return name.generic_string();
}

}  // namespace

std::vector<SceneFile> findScenes(std::span<const std::string> paths) {
  std::vector<SceneFile> found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (fs::is_directory(path, error))
      searchFolder(path, found);
    else if (fs::exists(path, error))
      found.push_back({fs::path(path).stem().string(), path});
    else
      fail(ExitCode::usage, "there is no scene or folder {}", path);
  }
  std::map<std::string, int> uses;
  for (const SceneFile& scene : found) ++uses[scene.name];
  for (SceneFile& scene : found)
    if (uses[scene.name] > 1) scene.name = wholeName(scene.file);
  std::sort(found.begin(), found.end(),
            [](const SceneFile& a, const SceneFile& b) { return a.name < b.name; });
  // A file that was given twice counts once.
  found.erase(std::unique(found.begin(), found.end(),
                          [](const SceneFile& a, const SceneFile& b) { return a.name == b.name; }),
              found.end());
  return found;
}

bool matches(const std::string& glob, const std::string& name) {
  return ::fnmatch(glob.c_str(), name.c_str(), 0) == 0;
}

std::vector<SceneFile> filtered(const std::vector<SceneFile>& scenes, std::span<const std::string> globs) {
  if (globs.empty()) return scenes;
  std::vector<SceneFile> kept;
  for (const SceneFile& scene : scenes)
    if (std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
          return matches(glob, scene.name) || matches(glob, scene.file.generic_string());
        }))
      kept.push_back(scene);
  return kept;
}

std::pair<std::size_t, std::size_t> shardNumbers(const std::string& shard) {
  const auto numbers = integerPair(shard, '/');
  if (!numbers || numbers->first < 1 || numbers->first > numbers->second)
    fail(ExitCode::usage, "--shard takes k/n with 1 <= k <= n, for example 2/4, not \"{}\"", shard);
  return {static_cast<std::size_t>(numbers->first), static_cast<std::size_t>(numbers->second)};
}

std::string shardNote(const std::string& shard, std::size_t tested, std::size_t whole, const char* unit) {
  return fmt::format("shard {}: {} of {} {}{}", shard, tested, whole, unit, whole == 1 ? "" : "s");
}

}  // namespace simreel::golden

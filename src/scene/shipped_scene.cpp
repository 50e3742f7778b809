#include "scene/shipped_scene.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns advice about a picture or mesh that was given in place of a scene, or an empty text for other
/// files.
std::string cureFor(const std::string& file) {
  const std::string ending = lowerExtension(file);
  const auto any = [&](const std::set<std::string>& endings) { return endings.contains(ending); };
  const std::string name = oneLine(file);
  if (any({".png", ".jpg", ".jpeg", ".hdr", ".exr", ".tga", ".bmp"}))
    return fmt::format(
        "{} is a picture, not a scene; a scene may use it as a \"texture\" of a material, as "
        "the \"image\" of a \"contour\", or as a map: `simreel new contour`",
        name);
  return "";
}

}  // namespace

std::vector<std::string> shippedScenes() {
  return scenesIn(assetFolder() / "scenes");
}

std::string sceneFile(const std::string& name) {
  if (name == "-" || name.empty()) return name;
  if (const std::string cure = cureFor(name); !cure.empty()) fail(ExitCode::usage, "{}", cure);
  if (pathExists(name)) return name;
  const fs::path path(name);
  const bool bare = !path.has_parent_path(), inScenes = path.parent_path() == "scenes";
  const std::string ending = lowerExtension(name);
  if ((!bare && !inScenes) || (!ending.empty() && ending != ".json")) return name;
  const std::vector<std::string> shipped = shippedScenes();
  const std::string stem = ending.empty() ? path.filename().string() : path.stem().string();
  if (std::find(shipped.begin(), shipped.end(), stem) != shipped.end()) {
    std::string found = (assetFolder() / "scenes" / (stem + ".json")).string();
    info("{} is the shipped scene {}", name, found);
    return found;
  }
  std::vector<std::string> near = scenesIn(bare ? fs::path(".") : path.parent_path());
  near.insert(near.end(), shipped.begin(), shipped.end());
  const std::string words = suggestion(stem, near);
  if (words.starts_with("did you mean"))
    fail(ExitCode::usage, "there is no scene {} here, and none is shipped under that name; {}", name,
         words);
  return name;
}

}  // namespace simreel::scene

#include "golden/baseline/inputs.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/strict_json.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/mesh/file/gltf_document.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view shipped = "<assets>/";

bool isBelow(const fs::path& file, const fs::path& folder) {
  return !folder.empty() &&
         std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

std::string nameOf(const fs::path& file) {
  std::error_code unknown;
  const fs::path here = fs::canonical(".", unknown);
  if (isBelow(file, here)) return file.lexically_relative(here).generic_string();
  const fs::path assets = fs::canonical(assetFolder(), unknown);
  if (!unknown && isBelow(file, assets))
    return std::string(shipped) + file.lexically_relative(assets).generic_string();
  return file.generic_string();
}

fs::path fileOf(const std::string& name) {
  if (name.starts_with(shipped)) return assetFolder() / name.substr(shipped.size());
  return name;
}

/// Returns the hash of a file, or an empty text if it does not exist.
std::string hashOf(const fs::path& file) {
  return pathExists(file) ? hashHex(readFile(file, "file")) : std::string();
}

/// Returns the buffer files of a glTF file. Ignores errors in the glTF file, because loading the mesh
/// reports them.
std::vector<fs::path> buffersOf(const fs::path& file) {
  std::vector<fs::path> buffers;
  if (lowerExtension(file) != ".gltf") return buffers;
  try {
    const auto json = parseStrictJson(readFile(file, "mesh"));
    if (const auto listed = JsonValue(json).find("buffers"))
      listed->eachItem([&](const JsonValue& buffer) {
        const auto uri = buffer.find("uri");
        if (!uri || uri->text().starts_with("data:")) return;
        const fs::path beside = file.parent_path() / sim::decodePercent(uri->text());
        // Files outside the glTF file's folder are never loaded, so that neither their hash nor their
        // existence is revealed.
        if (liesBelow(beside, file.parent_path())) buffers.push_back(beside);
      });
  } catch (const std::runtime_error&) {  // NOLINT(bugprone-empty-catch)
  }
  return buffers;
}

}  // namespace

Inputs inputsOf(const fs::path& scene, std::span<const fs::path> named) {
  Inputs inputs;
  for (const fs::path& file : {scene, scene::sidecarOf(scene)})
    inputs[file.generic_string()] = hashOf(file);
  for (const fs::path& file : named) {
    inputs[nameOf(file)] = hashOf(file);
    for (const fs::path& buffer : buffersOf(file)) inputs[nameOf(buffer)] = hashOf(buffer);
  }
  return inputs;
}

void checkUnchanged(const Inputs& inputs) {
  for (const auto& [name, hash] : inputs) {
    const fs::path file = fileOf(name);
    const bool exists = pathExists(file);
    if (!exists && !hash.empty())
      fail(ExitCode::usage, "{} is gone since that run; run the test again, and accept what that makes",
           name);
    if (hashOf(file) != hash)
      fail(ExitCode::usage, "{} has {} since that run; run the test again, and accept what that makes",
           name, hash.empty() ? "come" : "changed");
  }
}

}  // namespace simreel::golden

#include "scene/value/asset_path.hpp"

#include "scene/json/words.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>

#include <fmt/format.h>

namespace simreel::scene {

namespace fs = std::filesystem;

namespace {

bool isInside(const fs::path& file, const fs::path& root) {
  return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

/// Maps each file to the asset folders of the scenes that name it.
struct SceneFolders {
  std::mutex mutex;
  std::map<fs::path, std::set<fs::path>> folders;
};
SceneFolders& sceneFolders() {
  static SceneFolders all;
  return all;
}

void noteFolders(const fs::path& file, const std::vector<fs::path>& folders) {
  SceneFolders& all = sceneFolders();
  const std::scoped_lock lock(all.mutex);
  all.folders[file].insert(folders.begin(), folders.end());
}

}  // namespace

std::set<fs::path> foldersAround(const fs::path& file) {
  SceneFolders& all = sceneFolders();
  const std::scoped_lock lock(all.mutex);
  const auto found = all.folders.find(file);
  return found == all.folders.end() ? std::set<fs::path>() : found->second;
}

AssetFolders::AssetFolders(const fs::path& sceneFile, std::span<const fs::path> given,
                           const fs::path& shipped) {
  const fs::path sceneFolder = sceneFile.has_parent_path() ? sceneFile.parent_path() : fs::path(".");
  std::vector<fs::path> folders = {sceneFolder};
  folders.insert(folders.end(), given.begin(), given.end());
  folders.push_back(shipped);
  for (const fs::path& folder : folders) {
    if (folder.empty()) continue;
    std::error_code error;
    const fs::path canonical = fs::canonical(folder, error);
    // canonical() also removes a trailing slash, which would add an empty path element that no file
    // matches.
    if (!error && std::find(roots_.begin(), roots_.end(), canonical) == roots_.end())
      roots_.push_back(canonical);
  }
}

fs::path AssetFolders::find(const std::string& name, std::string& problem) const {
  const auto insideAny = [&](const fs::path& file) {
    return std::any_of(roots_.begin(), roots_.end(),
                       [&](const fs::path& root) { return isInside(file, root); });
  };
  std::string folders;
  for (const fs::path& root : roots_) folders += (folders.empty() ? "" : " and ") + root.string();
  if (name.find('\0') != std::string::npos) {
    problem = "a file name must not contain a zero byte";
    return {};
  }
  bool outside = false;
  for (const fs::path& root : roots_) {
    std::error_code error;
    fs::path file = fs::weakly_canonical(root / name, error);
    if (error) continue;
    if (!insideAny(file)) {
      outside = true;
      continue;
    }
    const fs::file_status status = fs::status(file, error);
    if (error || !fs::exists(status)) continue;
    if (fs::is_regular_file(status)) {
      noteFolders(file, roots_);
      return *found_.insert(file).first;
    }
    problem = fmt::format("{} is not a file", inQuotes(name));
    return {};
  }
  problem = outside
                ? fmt::format(
                      "{} lies outside the folders a scene may read: {}; --assets DIR lets it read another",
                      inQuotes(name), folders)
                : fmt::format("no file {} in {}", inQuotes(name), folders.empty() ? "any folder" : folders);
  return {};
}

}  // namespace simreel::scene

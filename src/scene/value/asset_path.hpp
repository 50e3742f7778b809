#pragma once
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace simreel::scene {

/// Resolves the file names in a scene. Scenes may be untrusted, so every file, with symbolic links
/// resolved, must lie below the scene's folder, a folder given by the user or the asset folder.
class AssetFolders {
 public:
  /// `sceneFile` need not exist. Its folder is searched first, then `given` in order, then `shipped`. Empty
  /// and missing folders are skipped.
  AssetFolders(const std::filesystem::path& sceneFile, std::span<const std::filesystem::path> given,
               const std::filesystem::path& shipped);

  /// Returns the full path of the file. If the file is missing or outside all folders, returns an empty
  /// path and sets `problem` to the reason.
  [[nodiscard]] std::filesystem::path find(const std::string& name, std::string& problem) const;
  /// Returns all files that find() has found so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return found_; }

 private:
  std::vector<std::filesystem::path> roots_;  ///< canonical paths of the folders that are searched
  mutable std::set<std::filesystem::path> found_;
};

/// Returns the asset folders of all scenes in this process that have named `file`. Files that `file` itself
/// refers to, such as a mesh's textures, may lie in these folders.
[[nodiscard]] std::set<std::filesystem::path> foldersAround(const std::filesystem::path& file);

}  // namespace simreel::scene

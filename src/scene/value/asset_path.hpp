#pragma once
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace simreel::scene {

/// Finds the files a scene names. A scene may come from anywhere, so what it names must lie, symbolic
/// links followed, below the scene's own folder, one the user gave or the asset folder.
class AssetFolders {
 public:
  /// `sceneFile` need not exist; its folder is looked in first, then `given` in their order, then
  /// `shipped`. Empty folders and ones that are not there count for nothing.
  AssetFolders(const std::filesystem::path& sceneFile, std::span<const std::filesystem::path> given,
               const std::filesystem::path& shipped);

  /// Full path of the file; empty, with the reason in `problem`, when it is missing or outside.
  [[nodiscard]] std::filesystem::path find(const std::string& name, std::string& problem) const;
  /// What find() has found so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return found_; }

 private:
  std::vector<std::filesystem::path> roots_;  ///< canonical
  mutable std::set<std::filesystem::path> found_;
};

/// Returns the folders of all scenes of this process that have named `file`. Files that `file` names in
/// turn, such as a mesh's textures, may lie in them.
[[nodiscard]] std::set<std::filesystem::path> foldersAround(const std::filesystem::path& file);

}  // namespace simreel::scene

#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::scene {

/// Finds the files a scene names. A scene may come from anywhere, so what it names must lie, symbolic
/// links followed, inside the scene's own folder or the asset folder.
class AssetFolders {
 public:
  /// `sceneFile` need not exist; its folder is looked in first. An empty `assets` means there is none.
  AssetFolders(const std::filesystem::path& sceneFile, const std::filesystem::path& assets);

  /// Full path of the file; empty, with the reason in `problem`, when it is missing or outside.
  [[nodiscard]] std::filesystem::path find(const std::string& name, std::string& problem) const;

 private:
  std::vector<std::filesystem::path> roots_;  ///< canonical
};

}  // namespace simreel::scene

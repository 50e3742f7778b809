#pragma once
#include "base/error.hpp"
#include "golden/suite/scene_set.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// A shell command that makes pictures with any program. {scene} is replaced by a file, {output} by where
/// its picture is to go, FOLDER/name.png; followed by "." or "/" it is FOLDER/name, so that {output}.exr
/// has another kind and {output}/####.png makes several. Without {scene} it runs once, and {output} is
/// FOLDER.
struct RenderCommand {
  std::string text;
  std::filesystem::path folder;

  /// Throws UserError(usage) for one without {output}.
  void check() const;
  [[nodiscard]] bool eachScene() const { return text.find("{scene}") != std::string::npos; }
  /// Both words quoted for the shell.
  [[nodiscard]] std::string of(const SceneFile& scene) const;
  /// For each scene: removes what an earlier run left of its pictures, runs the command, and tells how that
  /// failed, or that it made none. So many run at once. Throws Interrupted after a signal.
  [[nodiscard]] std::vector<std::optional<UserError>> runAll(const std::vector<SceneFile>& scenes,
                                                             std::size_t jobs) const;

 private:
  void makeRoom(const SceneFile& scene) const;
  void run(const SceneFile& scene) const;
  void checkMade(const SceneFile& scene) const;
  /// What lies in the folder of its pictures.
  [[nodiscard]] std::vector<std::string> madeOf(const SceneFile& scene) const;
};

/// The files to render: those given, and all below folders given, hidden ones apart; named by their paths
/// without extension. Throws as findScenes() does.
[[nodiscard]] std::vector<SceneFile> findInputs(std::span<const std::string> paths);

/// The scene whose picture this is: the longest name that the picture's path begins with, up to ".", "/" or
/// the end; nullptr: none.
[[nodiscard]] const SceneFile* ownerOf(const std::string& picture, const std::vector<SceneFile>& scenes);

}  // namespace simreel::golden

#pragma once
#include "golden/suite/scene_set.hpp"

#include <filesystem>
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
  /// Removes what an earlier run left of this scene's pictures, runs the command and throws UserError where
  /// it fails or leaves none; Interrupted after a signal.
  void run(const SceneFile& scene) const;
};

/// The files to render: those given, and all below folders given, hidden ones apart; named by their paths
/// without extension. Throws as findScenes() does.
[[nodiscard]] std::vector<SceneFile> findInputs(std::span<const std::string> paths);

/// The scene whose picture this is: the longest name that the picture's path begins with, up to ".", "/" or
/// the end; nullptr: none.
[[nodiscard]] const SceneFile* ownerOf(const std::string& picture, const std::vector<SceneFile>& scenes);

}  // namespace simreel::golden

#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::scene {

/// Input of a run: a scene's file or text, with its overrides and asset folders. It can be read repeatedly
/// with the same result.
struct SceneInput {
  std::filesystem::path file;                      ///< path of the scene; "-": standard input
  std::optional<std::string> text = {};            ///< text of the scene, which `file` names in messages;
                                                   ///< nullopt: the text of the file
  std::vector<Override> overrides = {};            ///< values that replace those of the scene
  std::vector<std::filesystem::path> assets = {};  ///< additional folders for files of the scene

  /// Returns the scene, as loadScene() and parseScene() do.
  [[nodiscard]] Scene load(const Kinds& kinds) const;
  /// Returns the scene with the tests of the sidecar if it is a file, as loadTestScene() does.
  [[nodiscard]] Scene loadForTest(const Kinds& kinds) const;
  /// Returns the scene as sceneAsRun() and textAsRun() do.
  [[nodiscard]] std::string asRun(const Kinds& kinds) const;
};

}  // namespace simreel::scene

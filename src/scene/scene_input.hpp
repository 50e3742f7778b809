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

  /// Reads and validates the scene, with its overrides applied, by loadScene() or parseScene().
  [[nodiscard]] Scene load(const Kinds& kinds) const;
  /// Does the same as load(), and also reads the tests of the scene's sidecar file (loadTestScene()). A
  /// scene that is given as text has no sidecar.
  [[nodiscard]] Scene loadForTest(const Kinds& kinds) const;
  /// Returns the scene with its overrides applied, as plain JSON (see sceneAsRun()).
  [[nodiscard]] std::string asRun(const Kinds& kinds) const;
};

}  // namespace simreel::scene

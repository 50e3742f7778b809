#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string_view>

namespace simreel::scene {

/// Reads and checks a scene. The file "-" is standard input, whose folder is the current directory. The
/// scene may name files below its own folder, `folders` and the asset folder. Throws UserError(usage) with
/// *all* errors in its message, each as "file:line:column: error: text", the source line and a caret.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file, std::span<const Override> overrides,
                              const Kinds& kinds, std::span<const std::filesystem::path> folders = {});
/// Does the same as loadScene() for scene text. `file` names the text in messages and locates assets.
[[nodiscard]] Scene parseScene(std::string_view text, const std::filesystem::path& file,
                               std::span<const Override> overrides, const Kinds& kinds,
                               std::span<const std::filesystem::path> folders = {});

/// Returns the path of the sidecar, a file in the folder of a scene that can contain the scene's tests:
/// flag.test.json for flag.json.
[[nodiscard]] std::filesystem::path sidecarOf(const std::filesystem::path& sceneFile);
/// Loads a scene for testing, like loadScene(). If the sidecar exists, its members "test" and "checks"
/// replace the scene's members of the same name. Overrides are applied after that. Errors in the sidecar
/// are reported at the sidecar's file:line:column. Test frames after the scene's end are errors even if an
/// override changes the length. loadScene() does not report them in that case.
[[nodiscard]] Scene loadTestScene(const std::filesystem::path& file, std::span<const Override> overrides,
                                  const Kinds& kinds, std::span<const std::filesystem::path> folders = {});

}  // namespace simreel::scene

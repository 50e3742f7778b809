#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string_view>

namespace simreel::scene {

/// Reads and checks a scene; the file "-" is standard input, which stands in the current folder. It may
/// name files below its own folder, `folders` and the asset folder. Throws UserError(usage) whose message
/// holds *every* mistake, each as "file:line:column: error: text", the line, and a caret.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file, std::span<const Override> overrides,
                              const Kinds& kinds, std::span<const std::filesystem::path> folders = {});
/// The same from text; `file` names it in messages and locates assets.
[[nodiscard]] Scene parseScene(std::string_view text, const std::filesystem::path& file,
                               std::span<const Override> overrides, const Kinds& kinds,
                               std::span<const std::filesystem::path> folders = {});

/// The file that may lie beside a scene and hold its tests: flag.test.json for flag.json.
[[nodiscard]] std::filesystem::path sidecarOf(const std::filesystem::path& sceneFile);
/// As loadScene, for testing: where the sidecar exists, its "test" and "checks" replace the scene's own,
/// each as a whole; overrides come last. Its mistakes are reported with its own file:line:column. Frames of
/// tests are held against the scene's length even when an override changes that length, which loadScene
/// allows.
[[nodiscard]] Scene loadTestScene(const std::filesystem::path& file, std::span<const Override> overrides,
                                  const Kinds& kinds, std::span<const std::filesystem::path> folders = {});

}  // namespace simreel::scene

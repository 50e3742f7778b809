#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <utility>

namespace simreel::scene {

/// Returns a scene's text, and the path used for messages and for locating assets. If the format of `file`
/// belongs to one of the `kinds`, the text is a generated scene that uses the file. The file "-" is
/// standard input. Throws UserError(usage) if the file cannot be read.
[[nodiscard]] std::pair<std::string, std::filesystem::path> readSceneSource(
    const std::filesystem::path& file, const Kinds& kinds);

}  // namespace simreel::scene

#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <utility>

namespace simreel::scene {

/// A scene's text (of a file of some kind's own format: that of the scene around it), and the file that
/// messages and assets go by. "-" is standard input. Throws UserError(usage) for what cannot be read.
[[nodiscard]] std::pair<std::string, std::filesystem::path> readSceneSource(
    const std::filesystem::path& file, const Kinds& kinds);

}  // namespace simreel::scene

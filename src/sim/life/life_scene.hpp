#pragma once
#include <filesystem>
#include <string>

namespace simreel::sim {

/// Returns the JSON text of a scene for a pattern file: the pattern in the centre of an object named
/// "cells", space around it, ten seconds. Empty if the name is not a pattern's. Throws the errors of
/// readPattern().
[[nodiscard]] std::string sceneAroundPattern(const std::filesystem::path& file);

}  // namespace simreel::sim

#pragma once
#include <filesystem>
#include <string>

namespace simreel::sim {

/// Returns the JSON text of a scene for a pattern file. The scene shows the pattern in the centre of an
/// object named "cells", with space around it, for ten seconds. Returns an empty string if the file's name
/// does not have the extension of a pattern file. Throws the errors of readPattern().
[[nodiscard]] std::string sceneAroundPattern(const std::filesystem::path& file);

}  // namespace simreel::sim

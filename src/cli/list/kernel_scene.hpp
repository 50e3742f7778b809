#pragma once
#include "kernels/shader/shader.hpp"

#include <filesystem>
#include <string>

namespace simreel::cli {

/// Returns a scene that runs the kernels of a file, for a user to change: sizes and values are guesses by
/// name.
[[nodiscard]] std::string sceneOf(const kernels::Shader& shader, const std::filesystem::path& file);

}  // namespace simreel::cli

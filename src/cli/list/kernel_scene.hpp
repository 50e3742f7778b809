#pragma once
#include "kernels/shader/shader.hpp"

#include <filesystem>
#include <string>

namespace simreel::cli {

/// Returns a scene that runs the kernels of a file, which users can edit. Sizes and values are guessed from
/// the names of the kernels' parameters.
[[nodiscard]] std::string sceneOf(const kernels::Shader& shader, const std::filesystem::path& file);

}  // namespace simreel::cli

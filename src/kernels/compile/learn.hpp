#pragma once
#include "kernels/source/files.hpp"

#include <string_view>

namespace simreel::kernels {

/// Adds remedies to `files` for what a log of glslang's tells of a text of HLSL. False where there is no
/// new one.
[[nodiscard]] bool learn(Files& files, std::string_view log);

}  // namespace simreel::kernels

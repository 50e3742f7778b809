#pragma once
#include "kernels/source/files.hpp"

#include <string_view>

namespace simreel::kernels {

/// Adds remedies to `files` for the errors in a glslang log of an HLSL text. Returns false if there is no
/// new remedy.
[[nodiscard]] bool learn(Files& files, std::string_view log);

}  // namespace simreel::kernels

#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <string_view>

namespace simreel::kernels {

/// Adds remedies to `files` for the errors in a glslang log of an HLSL text. Returns false if there is no
/// new remedy.
[[nodiscard]] bool learn(Files& files, std::string_view log);

/// Moves initializers of static variables that call functions to the beginning of a kernel. Returns false
/// if there is none that is not moved yet.
[[nodiscard]] bool learnStarts(Files& files, const std::string& entry);

}  // namespace simreel::kernels

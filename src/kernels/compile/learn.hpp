#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <string_view>

namespace simreel::kernels {

/// Adds remedies to `files` for the errors in a glslang log of an HLSL text. Returns false if there is no
/// new remedy.
[[nodiscard]] bool learn(Files& files, std::string_view log);

/// Moves the initializers of static variables to the beginning of a kernel if they call functions. Returns
/// false if all of them were moved before.
[[nodiscard]] bool learnStarts(Files& files, const std::string& entry);

}  // namespace simreel::kernels

#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <string_view>

namespace simreel::kernels {

/// Adds remedies to `files` for the errors in glslang's log of an HLSL text. Returns false if no remedy is
/// new.
[[nodiscard]] bool addRemedies(Files& files, std::string_view log);

/// Moves the initializers of static variables to the beginning of a kernel if the initializers call
/// functions. Returns false if there was nothing to move.
[[nodiscard]] bool moveStaticInitializers(Files& files, const std::string& entry);

}  // namespace simreel::kernels

#pragma once
#include <string>

namespace simreel::kernels {

/// A text of HLSL in which "unsigned int" is "uint" and groupshared variables stand behind the constant
/// buffer that they are written in, as Microsoft's compiler takes them. Lines keep their numbers.
[[nodiscard]] std::string dialect(const std::string& text);

}  // namespace simreel::kernels

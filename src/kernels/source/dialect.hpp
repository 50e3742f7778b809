#pragma once
#include <string>

namespace simreel::kernels {

/// Returns an HLSL text with "unsigned int" replaced by "uint" and groupshared variables moved behind the
/// constant buffer that contains them. Microsoft's compiler accepts both forms, glslang does not. Line
/// numbers do not change.
[[nodiscard]] std::string dialect(const std::string& text);

}  // namespace simreel::kernels

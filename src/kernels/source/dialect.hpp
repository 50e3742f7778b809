#pragma once
#include <string>

namespace simreel::kernels {

/// Returns an HLSL text with changes that glslang needs. "unsigned int" becomes "uint", typed buffers
/// become structured buffers, interfaces are blanked, and groupshared variables move out of constant
/// buffers. Microsoft's compiler accepts the original forms, but glslang does not. Line numbers do not
/// change.
[[nodiscard]] std::string dialect(const std::string& text);

}  // namespace simreel::kernels

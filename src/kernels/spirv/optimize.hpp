#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Makes HLSL's SPIR-V one that GLSL can say (`legalize`: opaque values lose their copies, functions their
/// resources), and drops what nothing uses. It changes no bits where NoContraction stands. Throws
/// std::runtime_error.
[[nodiscard]] Words optimized(const Words& words, bool legalize);

}  // namespace simreel::kernels

#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Optimizes a module: removes unused code and, with `legalize`, transforms HLSL's SPIR-V into a form that
/// GLSL can express (no copies of opaque values, no resource parameters). Results of instructions with
/// NoContraction do not change. Throws std::runtime_error.
[[nodiscard]] Words optimized(const Words& words, bool legalize);

}  // namespace simreel::kernels

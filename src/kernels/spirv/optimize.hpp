#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Optimizes a module. Removes unused code. With `legalize`, also transforms the SPIR-V of HLSL into a form
/// that GLSL can express (no copies of opaque values, no resource parameters). Results of instructions with
/// NoContraction do not change. Throws std::runtime_error.
[[nodiscard]] Words optimized(const Words& words, bool legalize);

}  // namespace simreel::kernels

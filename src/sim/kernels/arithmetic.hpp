#pragma once
#include "gl/program.hpp"

#include <string>

namespace simreel::sim {

/// How a driver computes for users' kernels. Drivers differ in how they reach the same bits.
enum class Arithmetic {
  /// Subnormal results become zero; 1 / x and sqrt(x) are rounded to nearest.
  rounded,
  /// Subnormal results become zero; fma() rounds once and corrects 1 / x and inversesqrt(x).
  fused,
  /// Neither. Kernels must be compiled with `kernels::Request::careful`.
  careful
};

/// Returns how the current context's driver computes. Measures it at the first call for each device: 4096
/// reciprocals and roots, and products and sums near 2^-126. The variable SIMREEL_CAREFUL=1 selects
/// `careful`.
[[nodiscard]] Arithmetic kernelArithmetic();

/// Returns the arithmetic in words, for `simreel doctor`.
[[nodiscard]] const char* arithmeticText(Arithmetic arithmetic);

/// Returns the program of a user's kernel for the current context's driver. `text`: GLSL of
/// kernels::Kernel::body().
[[nodiscard]] gl::Program kernelProgram(const std::string& label, const std::string& text);

}  // namespace simreel::sim

#pragma once
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A call of a library function at index `at` of a module's body. `function` is the function's name as
/// glslang mangles it, such as "xDiv(f1;f1;".
struct PlacedCall {
  std::size_t at;
  std::string function;
};

/// Replaces every operation whose result depends on the driver by a library call, and adds NoContraction to
/// the remaining operations. Returns the calls, whose function ids linkLibrary() fills in.
/// `careful`: also products and sums, for drivers that do not flush subnormal results to zero.
[[nodiscard]] std::vector<PlacedCall> placeCalls(Module& module, Language language, bool careful);

/// Appends the called library functions, and the functions that they call in turn, with new ids of the
/// module.
void linkLibrary(Module& module, const std::vector<PlacedCall>& calls, bool careful);

/// Adds NoContraction to every arithmetic operation of the body.
void forbidContraction(Module& module);

}  // namespace simreel::kernels

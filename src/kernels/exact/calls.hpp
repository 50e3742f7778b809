#pragma once
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A call of a function of the library in a module's body, by the name that glslang gives it:
/// "xDiv(f1;f1;".
struct PlacedCall {
  std::size_t at;
  std::string function;
};

/// Puts calls in place of every operation whose result a driver may choose, and NoContraction on those that
/// stay. The calls name no function until linkLibrary().
[[nodiscard]] std::vector<PlacedCall> placeCalls(Module& module, Language language);

/// Appends the functions that are called, and those that they call, with ids of the module's.
void linkLibrary(Module& module, const std::vector<PlacedCall>& calls);

/// NoContraction on every arithmetic operation of the body.
void forbidContraction(Module& module);

}  // namespace simreel::kernels

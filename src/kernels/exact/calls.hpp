#pragma once
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A call of a library function in a module's body. `function` is glslang's mangled name, such as
/// "xDiv(f1;f1;".
struct PlacedCall {
  std::size_t at;
  std::string function;
};

/// Replaces every operation with driver-dependent results by a library call, and adds NoContraction to the
/// remaining operations. The calls have no function ids until linkLibrary().
[[nodiscard]] std::vector<PlacedCall> placeCalls(Module& module, Language language);

/// Appends the called library functions, and the functions that they call, with new ids of the module.
void linkLibrary(Module& module, const std::vector<PlacedCall>& calls);

/// Adds NoContraction to every arithmetic operation of the body.
void forbidContraction(Module& module);

}  // namespace simreel::kernels

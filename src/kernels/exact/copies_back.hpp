#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <vector>

namespace simreel::kernels {

/// Repairs calls whose argument for an inout parameter has another type: glslang stores the result in the
/// converted value instead of the argument. Returns mistakes for arguments that are more than a variable.
[[nodiscard]] std::vector<Mistake> copyBack(Module& module, const Files& files);

}  // namespace simreel::kernels

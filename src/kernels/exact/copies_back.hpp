#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <vector>

namespace simreel::kernels {

/// Repairs calls in which the argument for an inout parameter has another type than the parameter. glslang
/// stores the result in the converted copy of the argument instead of the argument itself. Returns mistakes
/// for arguments that are not plain variables.
[[nodiscard]] std::vector<Mistake> copyBack(Module& module, const Files& files);

}  // namespace simreel::kernels

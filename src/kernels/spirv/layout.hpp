#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Makes the module one that GLSL 4.5 can say: push constants become a uniform block, uniform blocks are
/// laid out as std140 and buffers of HLSL as std430 (whose rules GLSL has not).
void layOut(Module& module, bool hlsl);

/// Gives every resource a binding of its own among its kind, in the order in which they stand.
void bindResources(Module& module);

}  // namespace simreel::kernels

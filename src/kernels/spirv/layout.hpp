#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Converts the module's memory layout to one that GLSL 4.5 can express: push constants become a uniform
/// block, uniform blocks use std140, and HLSL buffers use std430, because GLSL does not have HLSL's layout
/// rules.
void layOut(Module& module, bool hlsl);

/// Gives every resource a unique binding within its kind, in order of declaration.
void bindResources(Module& module);

}  // namespace simreel::kernels

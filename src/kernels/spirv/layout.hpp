#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Converts the module's memory layout to a layout that GLSL 4.5 can express, because GLSL lacks HLSL's
/// layout rules. Push constants become a uniform block. Uniform blocks use std140, and HLSL buffers use
/// std430.
void layOut(Module& module, bool hlsl);

/// Gives every resource a binding that is unique among resources of its kind, in order of declaration.
void bindResources(Module& module);

}  // namespace simreel::kernels

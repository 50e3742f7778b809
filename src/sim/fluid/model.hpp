#pragma once
// Compiles as C++ the files of glsl/fluid that work in both languages, in namespace simreel::shader.
#include "sim/core/shader_code.hpp"

namespace simreel::shader {
#define FUNCTION inline
#define precise
#include "glsl/fluid/model.glsl"
static_assert(sizeof(FluidStep) == 96);
static_assert(sizeof(FluidLevelPlace) == 48);
static_assert(sizeof(FluidSolidSet) == 9216);
static_assert(sizeof(FluidBrush) == 128);
#undef precise
#undef FUNCTION
}  // namespace simreel::shader

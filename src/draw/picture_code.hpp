#pragma once
// C++ versions (in simreel::shader) of the GLSL functions that exact pictures use. Their results have the
// same bits as the kernels.
#include "sim/core/shader_code.hpp"

#define FUNCTION inline
#define precise
#define EXACT_PICTURE
namespace simreel::shader {
#include "glsl/draw/arithmetic.glsl"
#include "glsl/draw/screen/film.glsl"
#include "glsl/draw/surface/shading.glsl"
}  // namespace simreel::shader
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

#pragma once
// Compiles the shared shader files of glsl/common as C++ in namespace simreel::shader.
#include "glsl/common/cpp.hpp"

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/common/exact.glsl"
#include "glsl/common/hash.glsl"
#include "glsl/grid/stroke.glsl"
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

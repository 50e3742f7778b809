#pragma once

namespace simreel::shader::water {

#include "glsl/water/bindings.glsl"
#include "glsl/water/float_bindings.glsl"

}  // namespace simreel::shader::water

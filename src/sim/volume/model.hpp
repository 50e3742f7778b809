#pragma once
#include "sim/core/shader_code.hpp"

namespace simreel::shader::volume {
#include "glsl/volume/bindings.glsl"
}  // namespace simreel::shader::volume

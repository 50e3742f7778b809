#pragma once
#include "draw/draw_state.hpp"

namespace simreel::draw {

#include "glsl/draw/exact/bindings.glsl"

}  // namespace simreel::draw

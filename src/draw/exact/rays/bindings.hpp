#pragma once
#include "draw/exact/bindings.hpp"

namespace simreel::draw {

#include "glsl/draw/exact/rays/bindings.glsl"

}  // namespace simreel::draw

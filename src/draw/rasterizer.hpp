#pragma once
#include "scene/scene.hpp"

namespace simreel::draw {

/// Kind of rasterizer. driver: the rasterizer of the OpenGL driver. exact: compute kernels in exact
/// arithmetic, which give the same bits on every machine.
using scene::Rasterizer;

}  // namespace simreel::draw

#pragma once
#include "scene/scene.hpp"

namespace simreel::draw {

/// Who draws. driver: the driver's own rasterizer. exact: kernels in exact arithmetic, the same bits on
/// every machine.
using scene::Rasterizer;

}  // namespace simreel::draw

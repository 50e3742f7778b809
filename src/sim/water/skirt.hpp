#pragma once
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/water/plan.hpp"

namespace simreel::sim {

/// Returns the vertical sides of the ground in world space: from the drawn heights at the grid's border
/// down to slightly below the lowest bed. `walls`: bit mask of the sides (west, east, north, south) whose
/// minimum height is `rim` (metres, relative to level 0). u counts grid widths along a side, v grid widths
/// downwards.
[[nodiscard]] Mesh groundSides(const WaterPlan& plan, int walls, float rim);

}  // namespace simreel::sim

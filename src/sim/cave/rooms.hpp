#pragma once
#include "sim/cave/regions.hpp"
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the regions of open cells connected over edges, ordered by their lowest cell. `cells` has one
/// bit per cell, 1 for rock, in the layout of the GPU (glsl/cave/cells.glsl); `side` is the cell width in
/// metres. Runs on the CPU in one sweep; used for exported files.
[[nodiscard]] std::vector<Room> caveRooms(const CaveGrid& grid, const std::vector<unsigned>& cells,
                                          float side);

}  // namespace simreel::sim

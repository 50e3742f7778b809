#pragma once
#include "sim/cave/regions.hpp"
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the connected regions of open cells (connected over edges), ordered by their lowest cell.
/// `cells`: one bit each, 1 for rock, in the GPU's layout (glsl/cave/cells.glsl); `side`: cell width in
/// metres. Runs on the CPU in one sweep, for exported files.
[[nodiscard]] std::vector<Room> caveRooms(const CaveGrid& grid, const std::vector<unsigned>& cells,
                                          float side);

}  // namespace simreel::sim

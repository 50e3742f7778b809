#pragma once
#include "sim/cave/regions.hpp"
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Regions of open cells, joined over edges, by their lowest cell. `cells`: a bit each, 1 rock, as the
/// GPU has them (glsl/cave/cells.glsl); `side` of a cell, m. For files: on the CPU, in one sweep.
[[nodiscard]] std::vector<Room> caveRooms(const CaveGrid& grid, const std::vector<unsigned>& cells,
                                          float side);

}  // namespace simreel::sim

#pragma once
#include "sim/cave/regions.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Cells from the start of the waves to `end`, both included: of the cells that lie one step nearer the one
/// with the lowest number. `distances` as CaveWaves has them; `end` was reached.
[[nodiscard]] std::vector<glm::ivec2> cavePath(const CaveGrid& grid, const std::vector<unsigned>& distances,
                                               unsigned end);

/// The path as a way to walk, in cells: each point drawn to the middle of its neighbours, as an elastic
/// band is, as long as all cells within one cell of it are open. Ends stay. Additions and halves only, so
/// that every machine finds the same way.
[[nodiscard]] std::vector<glm::dvec2> smoothPath(const CaveGrid& grid,
                                                 const std::vector<unsigned>& distances,
                                                 const std::vector<glm::ivec2>& path, int rounds);

}  // namespace simreel::sim

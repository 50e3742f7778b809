#pragma once
#include "sim/cave/regions.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Returns the shortest path from the cell at distance 0 to `end`, including both. It is found backwards
/// from `end`: the next cell is always the neighbour that is one step nearer to the start; among several
/// such neighbours, it is the one with the lowest index. `distances` has the format of CaveWaves; `end`
/// must be reachable.
[[nodiscard]] std::vector<glm::ivec2> cavePath(const CaveGrid& grid, const std::vector<unsigned>& distances,
                                               unsigned end);

/// Returns a smoothed path in cells. Each round moves each point towards the midpoint of its neighbours,
/// like an elastic band, and slightly towards the centre of the open space, provided that all cells within
/// one cell of the new position are open. The end points do not move. Uses only basic double arithmetic, so
/// every machine gets the same path.
[[nodiscard]] std::vector<glm::dvec2> smoothPath(const CaveGrid& grid,
                                                 const std::vector<unsigned>& distances,
                                                 const std::vector<glm::ivec2>& path, int rounds);

}  // namespace simreel::sim

#pragma once
#include "sim/life/cell_pattern.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Parses Golly's macrocell format ("[M2]", then a quadtree whose nodes follow their children) with two or
/// more states. Throws UserError with file:line:column for malformed or truncated text, for more than
/// `maxCells` live cells (counted before memory is allocated for them), and for cells further apart than
/// maxLifeSide.
[[nodiscard]] CellPattern parseMacrocell(std::string_view text, const std::string& name,
                                         std::size_t maxCells = std::size_t{1} << 27);

}  // namespace simreel::sim

#pragma once
#include "sim/life/cell_pattern.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads Golly's macrocell format ("[M2]", then a tree of squares, children first), of two states or of
/// several. Throws UserError with file:line:column for a malformed one, one cut off, and one whose cells
/// are more than `maxCells`, counted before any memory is taken for them, or further apart than
/// maxLifeSide.
[[nodiscard]] CellPattern parseMacrocell(std::string_view text, const std::string& name,
                                         std::size_t maxCells = std::size_t{1} << 27);

}  // namespace simreel::sim

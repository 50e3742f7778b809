#pragma once
#include "sim/life/cell_pattern.hpp"

#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads Golly's macrocell format ("[M2]", then a tree of squares, children first), of two states or of
/// several. Throws UserError with file:line:column for a malformed one, one cut off, and one whose cells
/// are more than 2^27 or further apart than maxLifeSide.
[[nodiscard]] CellPattern parseMacrocell(std::string_view text, const std::string& name);

}  // namespace simreel::sim

#pragma once
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Rectangle of cells, possibly in the ring around the grid, that brushes may change.
struct BrushBox {
  glm::ivec4 cells;        ///< First column and row, number of columns and rows.
  std::size_t first, end;  ///< Range of brushes; brushes outside the range do not reach these cells.
};

/// Returns one box per brush (boxes may overlap), or a single box of all cells if `all` is set or if the
/// boxes cover more than half the cells; `all` is then set.
[[nodiscard]] std::vector<BrushBox> brushBoxes(std::span<const shader::FluidBrush> brushes,
                                               const FluidParameters& p, bool& all);

}  // namespace simreel::sim

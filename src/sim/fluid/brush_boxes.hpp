#pragma once
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Rectangle of cells that brushes may change. It may include cells of the ring around the grid.
struct BrushBox {
  glm::ivec4 cells;        ///< First column and row, number of columns and rows.
  std::size_t first, end;  ///< Index range of brushes. Brushes outside the range do not affect these cells.
};

/// Returns one box per brush; boxes may overlap. Returns a single box of all cells, and sets `all`, if the
/// boxes cover more than half of the cells or if `all` is already true.
[[nodiscard]] std::vector<BrushBox> brushBoxes(std::span<const shader::FluidBrush> brushes,
                                               const FluidParameters& p, bool& all);

}  // namespace simreel::sim

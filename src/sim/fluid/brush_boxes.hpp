#pragma once
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// A part of a fluid's cells, the ring around them included, that brushes may change.
struct BrushBox {
  glm::ivec4 cells;        ///< first column and row, how many of each
  std::size_t first, end;  ///< of the brushes: others reach none of these cells
};

/// A box for each brush, which may overlap; or one of all cells, if `all` or if that is less to paint.
[[nodiscard]] std::vector<BrushBox> brushBoxes(std::span<const shader::FluidBrush> brushes,
                                               const FluidParameters& p, bool& all);

}  // namespace simreel::sim

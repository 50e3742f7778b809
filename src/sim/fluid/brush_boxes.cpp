#include "sim/fluid/brush_boxes.hpp"

#include <cstdint>

namespace simreel::sim {

namespace {

/// Returns the rectangle of cells that a brush may change (first column and row, number of columns and
/// rows), which may include ring cells. The rectangle includes the faces just beyond the brush's box and,
/// if the grid is periodic, the cells on the opposite side.
glm::ivec4 changedBy(const shader::FluidBrush& brush, const FluidParameters& p) {
  glm::ivec4 changed;
  for (int i = 0; i < 2; ++i) {
    int from = brush.box[i], end = from + brush.box[i + 2] + 1;
    const bool first = from == 0, last = end > p.size[i], wraps = i == 0 ? p.wrapsX() : p.wrapsY();
    if (first || (wraps && last)) from = -1;
    if (wraps && first) end = p.size[i] + 1;
    changed[i] = from;
    changed[i + 2] = end - from;
  }
  return changed;
}

bool meet(const glm::ivec4& a, const glm::ivec4& b) {
  return a.x < b.x + b.z && b.x < a.x + a.z && a.y < b.y + b.w && b.y < a.y + a.w;
}

}  // namespace

std::vector<BrushBox> brushBoxes(std::span<const shader::FluidBrush> brushes, const FluidParameters& p,
                                 bool& all) {
  const glm::ivec2 size = p.size + 2;
  std::vector<BrushBox> boxes;
  std::int64_t cells = 0;
  for (const shader::FluidBrush& brush : brushes) {
    boxes.push_back({changedBy(brush, p), 0, brushes.size()});
    cells += std::int64_t{boxes.back().cells.z} * boxes.back().cells.w;
  }
  all = all || 2 * cells > std::int64_t{size.x} * size.y;
  if (all) return {{glm::ivec4(-1, -1, size), 0, brushes.size()}};
  for (BrushBox& box : boxes) {
    while (!meet(boxes[box.first].cells, box.cells)) ++box.first;
    while (!meet(boxes[box.end - 1].cells, box.cells)) --box.end;
  }
  return boxes;
}

}  // namespace simreel::sim

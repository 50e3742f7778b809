// Records whether the next step would clamp a cell that is outside [0, 1] by more than rounding. Writes no cells. This
// is a separate kernel, because the test would make the arithmetic-bound stepping kernels a quarter slower. One
// invocation per element.
#include "gray_scott/grid.glsl"
#include "common/status.glsl"
layout(local_size_x = 32, local_size_y = 4) in;
const vec4 low = vec4(-1e-6), high = vec4(1.000001);

vec4 sidesAt(int x, int row) {
  return sideSums(cellPair(x - 1, row), cellPair(x, row), cellPair(x + 1, row));
}

// Returns u and v of one cell one step later, without the clamp to [0, 1].
vec2 freeCell(vec2 cell, vec2 edges, vec2 corners, vec2 local) {
  GrayScottRates r = cellRates(local);
  float reacted = reaction(cell.x, cell.y, rates.dt);
  return vec2(freeU(cell.x, laplacian20(cell.x, edges.x, corners.x), reacted, r),
              freeV(cell.y, laplacian20(cell.y, edges.y, corners.y), reacted, r));
}

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= columns || y >= size.y) return;
  int above = wrappedRow(y - 1), below = wrappedRow(y + 1);
  vec4 here = cellPair(x, y);
  precise vec4 corners = sidesAt(x, above) + sidesAt(x, below);
  precise vec4 edges = sidesAt(x, y) + (cellPair(x, above) + cellPair(x, below));
  vec4 local = ratesAt(y * columns + x);
  vec4 next = vec4(freeCell(here.xy, edges.xy, corners.xy, local.xy), freeCell(here.zw, edges.zw, corners.zw, local.zw));
  bool out_ = any(lessThan(next, low)) || any(greaterThan(next, high));
  if (out_ && status.remark == 0u) atomicOr(status.remark, 1u);
}

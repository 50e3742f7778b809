// Copies the cells into rows with a margin, which is filled from the opposite side of the torus. One invocation per
// element of four cells.
#include "common/memory.glsl"
#include "lenia/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(paddedBinding, PaddedBlock, padded)
uniform ivec2 size;  // Number of cells per axis
uniform int rowItems;  // Number of elements per row of cells
uniform int paddedItems;  // Number of elements per padded row
uniform int margin;  // Margin in cells, a multiple of 4
uniform int range;

float cellAt(int x, int y) {
  return LOAD_INPUT(cells, y * rowItems + (x >> 2))[x & 3];
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= paddedItems || at.y >= size.y + 2 * range) return;
  // The margin may be wider than the grid, so a row may have to be wrapped several times.
  int y = (at.y - range + 128 * size.y) % size.y;
  int x = at.x * 4 - margin;
  vec4 four;
  if (x >= 0 && x + 4 <= size.x)
    four = LOAD_INPUT(cells, y * rowItems + (x >> 2));
  else
    for (int i = 0; i < 4; ++i) four[i] = cellAt((x + i + 128 * size.x) % size.x, y);
  STORE_STATE(padded, at.y * paddedItems + at.x, four);
}

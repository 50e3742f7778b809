// Expands cells to bytes in rows with a margin, which is filled according to the topology of the grid, so that later
// kernels need no special cases at edges. An invocation writes 16 cells. BITS is defined if the cells are stored as
// bits.
#include "common/words.glsl"
#include "automata/bindings.glsl"
#include "automata/shape.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
INPUT_WORDS(cellsBinding, CellBlock, cells)
STATE_WORDS(paddedBinding, PaddedBlock, padded)
uniform GridJoin grid;
uniform int rowItems;  // Number of elements of 16 bytes per row of cells
uniform int paddedItems;  // Number of elements per padded row
uniform int marginX;  // Margin in cells, a multiple of 16
uniform int range;  // Number of padded rows above the grid, and number below

#ifdef BITS
const int CELLS = 128;
#else
const int CELLS = 16;
#endif

uint cellNumbered(int number) {
  uvec4 item = LOAD_INPUT_WORDS(cells, number / CELLS);
#ifdef BITS
  return item[number >> 5 & 3] >> uint(number & 31) & 1u;
#else
  return item[number >> 2 & 3] >> uint((number & 3) * 8) & 255u;
#endif
}

// Returns 16 cells of one element.
uvec4 cellsFrom(int number) {
  uvec4 item = LOAD_INPUT_WORDS(cells, number / CELLS);
#ifdef BITS
  uint bits = item[number >> 5 & 3] >> uint(number & 31);
  uvec4 four = uvec4(bits, bits >> 4u, bits >> 8u, bits >> 12u) & 15u;
  return four * 0x00204081u & 0x01010101u;
#else
  return item;
#endif
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= paddedItems || at.y >= grid.height + 2 * range) return;
  int x = at.x * 16 - marginX;
  int y = at.y - range;
  int rowCells = rowItems * CELLS;
  uvec4 block = uvec4(0u);
  if (y >= 0 && y < grid.height && x >= 0 && x + 16 <= grid.width) {
    block = cellsFrom(y * rowCells + x);
  } else if (x + 16 > -range && x < grid.width + range) {
    for (int i = 0; i < 16; ++i) {
      if (x + i < -range || x + i >= grid.width + range) continue;
      int number = joinedCell(grid, x + i, y, rowCells);
      if (number >= 0) block[i >> 2] |= cellNumbered(number) << uint((i & 3) * 8);
    }
  }
  STORE_WORDS(padded, at.y * paddedItems + at.x, block);
}

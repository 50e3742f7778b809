// Cells of the cave, 32 per word. A row has a multiple of four words; its unused bits are rock. A cell's index is the
// index of its bit, 32 rowWords y + x for cell (x, y), so indices increase along rows and from row to row.
#include "cave/bindings.glsl"
#include "common/hash.glsl"
#include "cave/model.glsl"
layout(std430, binding = cellsBinding) restrict buffer CellBlock { uint cells[]; };
uniform ivec2 size;    // Number of cells per axis
uniform int rowWords;  // Number of words per row

// Returns a word of cells. Outside the grid, all cells are rock.
uint rockAt(int column, int y) {
  if (column < 0 || column >= rowWords || y < 0 || y >= size.y) return ~0u;
  return cells[y * rowWords + column];
}

uint validBits(int column) {
  int left = size.x - 32 * column;
  return left >= 32 ? ~0u : left <= 0 ? 0u : (1u << uint(left)) - 1u;
}

bool isOpen(int x, int y) {
  return x >= 0 && x < size.x && (rockAt(x >> 5, y) >> uint(x & 31) & 1u) == 0u;
}

ivec2 placeOf(uint cell) {
  uint pitch = 32u * uint(rowWords);
  return ivec2(cell % pitch, cell / pitch);
}
uint numberOf(int x, int y) {
  return 32u * uint(rowWords) * uint(y) + uint(x);
}

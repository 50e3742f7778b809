// Cells of the cave, 32 a word, rows of whole groups of four words whose spare bits are rock. A cell's number is its
// bit's: (x, y) is 32 rowWords y + x, so numbers grow along rows and from row to row.
#include "cave/bindings.glsl"
#include "common/hash.glsl"
#include "cave/model.glsl"
layout(std430, binding = cellsBinding) restrict buffer CellBlock { uint cells[]; };
uniform ivec2 size;    // cells
uniform int rowWords;  // of a row

// Outside is rock.
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

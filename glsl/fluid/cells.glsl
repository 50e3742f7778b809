// Kernels that give four cells to an invocation: a block of 2x2 in a tile, or four of the ring around the grid. After
// grid.glsl.
#include "fluid/tiles.glsl"
uniform int tilesStart;  // elements: where the list is; below 0: the ring

// Cell i of the ring: above, below, left, right; beyond the grid where there is none.
ivec2 ringCell(int i) {
  int row = size.x + 2, sides = i - 2 * row;
  ivec2 c = i < row ? ivec2(i - 1, -1) : ivec2(i - row - 1, size.y);
  if (sides >= 0) c = ivec2(sides < size.y ? -1 : size.x, sides < size.y ? sides : sides - size.y);
  return sides >= 2 * size.y ? size + 2 : c;
}

// Cell k of this invocation, from 0 to 3; beyond the grid and its ring where there is none.
ivec2 cellHere(int k) {
  ivec2 inTile = 2 * blockHere(tilesStart) + ivec2(k & 1, k >> 1);
  if (inTile.x >= size.x || inTile.y >= size.y) inTile = size + 2;
  return tilesStart < 0 ? ringCell(4 * (64 * groupNumber() + int(gl_LocalInvocationIndex)) + k) : inTile;
}

// Work distribution of kernels that process each cell independently, in tiles or on the ring around the grid. On the
// texel path, an invocation processes four cells; in a tile, these are a block of 2x2. On the storage path, an
// invocation processes one cell and a workgroup one tile, because these kernels are long but process few cells. Include
// after grid.glsl.
#include "fluid/tiles.glsl"
uniform int tilesStart;  // Index of the tile list's first element, or a negative number to process the ring

// Returns cell i of the ring, in the order top, bottom, left, right. If i is too large, returns a cell outside the
// ring.
ivec2 ringCell(int i) {
  int row = size.x + 2, sides = i - 2 * row;
  ivec2 c = i < row ? ivec2(i - 1, -1) : ivec2(i - row - 1, size.y);
  if (sides >= 0) c = ivec2(sides < size.y ? -1 : size.x, sides < size.y ? sides : sides - size.y);
  return sides >= 2 * size.y ? size + 2 : c;
}

#ifdef TEXEL_PATH
const int cellsEach = 4;
// Returns cell k (less than cellsEach) of this invocation, or a cell outside the ring if this invocation has fewer
// cells.
ivec2 cellHere(int k) {
  ivec2 inTile = 2 * blockHere(tilesStart) + ivec2(k & 1, k >> 1);
  if (inTile.x >= size.x || inTile.y >= size.y) inTile = size + 2;
  return tilesStart < 0 ? ringCell(4 * (64 * groupNumber() + int(gl_LocalInvocationIndex)) + k) : inTile;
}
#else
const int cellsEach = 1;
ivec2 cellHere(int k) {
  int number = groupNumber();
  if (tilesStart < 0) return ringCell(64 * number + int(gl_LocalInvocationIndex));
  uvec4 four = LOAD_INPUT_WORDS(weights, tilesStart + (number >> 2));
  uint tile = (number & 2) == 0 ? ((number & 1) == 0 ? four.x : four.y) : (number & 1) == 0 ? four.z : four.w;
  ivec2 c = 8 * ivec2(tile & 0xffffu, tile >> 16u) + ivec2(gl_LocalInvocationID.xy);
  return c.x >= size.x || c.y >= size.y ? size + 2 : c;
}
#endif

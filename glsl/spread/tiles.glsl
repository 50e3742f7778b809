// Skips inactive tiles, on software drivers. A tile is the area of one invocation: sixteen cells across, rowsEach down.
// A tile is computed if a tile around it has active cells, if it has cells that change by themselves, or if it changed
// in the last step; otherwise both cell buffers already hold the same state. For a skipped tile the loop over rows is
// empty, so a workgroup of skipped tiles finishes at once.
//
// The including kernel provides
//   uvec4 restlessCells(uvec4 state)              not 0 for cells that change without an active cell near them
//   bool changesAlone(Rates rates, uvec4 counts)  true if cells with such class counts can change by chance in this
//   step
#ifdef TEXEL_PATH
// For each tile: its class counts, with flags in the upper half of the first word.
INPUT_WORDS(tilesBinding, TileBlock, tiles)
layout(std430, binding = nextTilesBinding) writeonly buffer NextTileBlock { uvec4 nextTiles[]; };
// True if `tiles` has no valid data. Then all tiles are computed, and the counts of the step start at 0 instead of the
// last counts
uniform bool fresh;

const uint changed = 0x10000u, restless = 0x20000u;
// Flags for active cells in the tile's top row, its last row, its first column and its last column.
const uint top = 0x40000u, bottom = 0x80000u, left = 0x100000u, right = 0x200000u;

uvec4 countsOf(uvec4 tile) { return uvec4(tile.x & 0xffffu, tile.yzw); }

// Returns the tile's data after the last step, or 0 if `fresh` is true.
uvec4 tileBefore(Column column, int row) {
  return fresh ? uvec4(0u) : LOAD_INPUT_WORDS(tiles, row * column.rowElements + column.here);
}

// Returns true if the tile has active cells at all edges in `edges`.
bool touches(Column column, int x, int row, uint edges) {
  return (LOAD_INPUT_WORDS(tiles, row * column.rowElements + x).x & edges) == edges;
}

// Returns true if a tile in another row of tiles touches this tile with active cells: directly at an edge, or
// diagonally at a corner, which requires two edges.
bool touchesFrom(Column column, int row, uint edge) {
  int rows = (column.size.y + rowsEach - 1) / rowsEach;
  bool beyond = row < 0 || row >= rows;
  if (beyond && !column.torus) return false;
  int there = beyond ? (row + rows) % rows : row;
  return touches(column, column.left, there, edge | right) || touches(column, column.here, there, edge) ||
         touches(column, column.right, there, edge | left);
}

bool standsStill(Rates rates, Column column, int row, uvec4 own) {
  bool near = own.y != 0u || touchesFrom(column, row - 1, bottom) || touchesFrom(column, row + 1, top) ||
              touches(column, column.left, row, right) || touches(column, column.right, row, left);
  return !fresh && !near && (own.x & (changed | restless)) == 0u && !changesAlone(rates, own);
}

// Returns the edge flags of a tile, from the active cells in its top row, in its last row and in all its rows. A row of
// the grid ends within its last tile.
uint edgesOf(Column column, uvec4 first, uvec4 last, uvec4 all) {
  uint end = column.here == column.rowElements - 1 ? all.x | all.y | all.z | all.w : all.w >> 24u;
  return (first != uvec4(0u) ? top : 0u) | (last != uvec4(0u) ? bottom : 0u) | ((all.x & 0xffu) != 0u ? left : 0u) |
         (end != 0u ? right : 0u);
}

void leaveTile(Column column, int row, uvec4 counted, uint flags) {
  nextTiles[row * column.rowElements + column.here] = uvec4(counted.x | flags, counted.yzw);
}
#endif

// Drivers on the CPU leave out what stands still. A tile is what an invocation steps: sixteen cells across, rowsEach down.
// It is computed where a tile around it holds active cells, where it holds cells that change by themselves, and where it
// changed in the last step: only then do both buffers of cells hold the same. An invocation that leaves its tile out has
// a loop over no rows; a work group of such invocations goes through the loop once instead of rowsEach times.
// The kernel that includes it gives
//   uvec4 restlessCells(uvec4 state)              not 0 where a cell will change without an active one near it
//   bool changesAlone(Rates rates, uvec4 counts)  whether cells of these classes may do so in this step, by chance
#ifdef TEXEL_PATH
// Of each tile: its counts, and in the upper half of the first what is said of it.
INPUT_WORDS(tilesBinding, TileBlock, tiles)
layout(std430, binding = nextTilesBinding) writeonly buffer NextTileBlock { uvec4 nextTiles[]; };
uniform bool fresh;  // `tiles` say nothing yet: all are computed, and the step's counts start at 0, not at the last ones

const uint changed = 0x10000u, restless = 0x20000u;
// Cells are active somewhere in the tile's top row, its last row, its first and its last column.
const uint top = 0x40000u, bottom = 0x80000u, left = 0x100000u, right = 0x200000u;

uvec4 countsOf(uvec4 tile) { return uvec4(tile.x & 0xffffu, tile.yzw); }

// As the last step left it; nothing where `fresh`.
uvec4 tileBefore(Column column, int row) {
  return fresh ? uvec4(0u) : LOAD_INPUT_WORDS(tiles, row * column.rowElements + column.here);
}

// Whether the tile has all of these edges active.
bool touches(Column column, int x, int row, uint edges) {
  return (LOAD_INPUT_WORDS(tiles, row * column.rowElements + x).x & edges) == edges;
}

// A tile in another row of tiles: nearer than one at a corner, which has two edges.
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

// Active cells in the tile's top row, its last row and all of its rows. A row of the grid ends within its last tile.
uint edgesOf(Column column, uvec4 first, uvec4 last, uvec4 all) {
  uint end = column.here == column.rowElements - 1 ? all.x | all.y | all.z | all.w : all.w >> 24u;
  return (first != uvec4(0u) ? top : 0u) | (last != uvec4(0u) ? bottom : 0u) | ((all.x & 0xffu) != 0u ? left : 0u) |
         (end != 0u ? right : 0u);
}

void leaveTile(Column column, int row, uvec4 counted, uint flags) {
  nextTiles[row * column.rowElements + column.here] = uvec4(counted.x | flags, counted.yzw);
}
#endif

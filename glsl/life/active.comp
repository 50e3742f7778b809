// Computes many generations in one dispatch of one workgroup, only in active tiles. A pass is STEPS generations; a tile
// is TILE_WORDS * 32 cells wide and TILE_ROWS high. In a pass, a cell depends only on cells at most STEPS <= 16 away.
// Therefore, a tile does not change in this pass if neither it nor its neighbours changed in the last pass, and both
// halves of `cells` already hold its state. A tile that changes marks the tiles near it for the next pass.
//
// It is made for software drivers, where a dispatch is expensive (60 to 90 us), a workgroup of 8 is one SIMD vector,
// and loops silently end after 65,535 iterations. LifeActive in src/sim/life counts the iterations, and the end of the
// kernel reports a loop that was cut off.
//
// Defines: BORN and SURVIVE, or FORMULA; TORUS for a torus; STEPS, TILE_WORDS, TILE_ROWS, TILES; OVERLAP if the height
// is not a multiple of TILE_ROWS.
#include "life/bindings.glsl"
layout(local_size_x = 8) in;
layout(r32ui, binding = cellsBinding) uniform coherent readonly uimageBuffer cellTexels;
layout(std430, binding = cellsBinding) coherent writeonly buffer CellBlock { uint cells[]; };
// For each tile: the pass in which it must be computed.
layout(std430, binding = marksBinding) coherent buffer MarkBlock { uint marks[]; };
// Number of cells per axis; the width is a multiple of TILE_WORDS * 32, the height at least TILE_ROWS and STEPS
uniform ivec2 size;
uniform int rowWords;  // Number of words per row
uniform uint firstPass;  // Number of the first pass: it reads half (firstPass & 1) of `cells` and writes the other half
uniform int passes;
uniform bool all;  // True if the first pass computes every tile

#include "common/status.glsl"
#define WORD uint
#ifdef FORMULA
#include "life/formula_model.glsl"
#else
#include "life/model.glsl"
#endif

shared uint list[TILES];
shared uint listed;

// Row of a tile with 16 additional cells on each side.
const int WORDS = TILE_WORDS + 1;
struct Row {
  uint word[WORDS];
};
struct RowSums {
  RowSum word[WORDS];
};
struct Strip {
  RowSums above[STEPS];  // Sums of the row two rows above the loaded row, for each generation
  RowSums here[STEPS];   // Sums of the row above the loaded row, for each generation
  Row alive[STEPS];      // Cells of the row above the loaded row, for each generation
};
// Tile: index of its first word in a row, its top row, masks of the cells that exist beside it, and masks of its
// changed cells: in all rows, in the first STEPS rows, and in the last STEPS rows.
struct Tile {
  int first, top;
  uint leftCells, rightCells;
  uint changed[TILE_WORDS], changedTop[TILE_WORDS], changedBottom[TILE_WORDS];
};

int tilesAcross() {
  return size.x / (TILE_WORDS * 32);
}
int tilesDown() {
  return (size.y + TILE_ROWS - 1) / TILE_ROWS;
}

int wrappedRow(int y) {
  return y < 0 ? y + size.y : (y >= size.y ? y - size.y : y);
}

uint cellsAt(int i) {
  return imageLoad(cellTexels, i).x;
}

// Cells beyond a dead border stay dead, whatever the rule.
void killOutside(inout Row row, Tile tile, int y) {
#ifndef TORUS
  bool outside = y < 0 || y >= size.y;
  row.word[0] &= tile.leftCells;
  row.word[TILE_WORDS] &= tile.rightCells;
  for (int k = 0; k < WORDS; ++k) row.word[k] = outside ? 0u : row.word[k];
#endif
}

Row loadRow(Tile tile, int y, int from) {
  int start = from + wrappedRow(y) * rowWords;
  int count = size.x >> 5;
  Row row;
  uint before = cellsAt(start + (tile.first == 0 ? count - 1 : tile.first - 1));
  for (int k = 0; k < WORDS; ++k) {
    int x = tile.first + k;
    uint word = cellsAt(start + (x == count ? 0 : x));
    row.word[k] = before >> 16u | word << 16u;
    before = word;
  }
  killOutside(row, tile, y);
  return row;
}

RowSums sumsOf(Row row) {
  RowSums sums;
  for (int k = 0; k < WORDS; ++k) {
    uint west = row.word[k] << 1u | (k > 0 ? row.word[max(k - 1, 0)] >> 31u : 0u);
    uint east = row.word[k] >> 1u | (k + 1 < WORDS ? row.word[min(k + 1, WORDS - 1)] << 31u : 0u);
    sums.word[k] = rowSum(west, row.word[k], east);
  }
  return sums;
}

// Reads row `y` of generation 0. When it is complete, also stores row y - STEPS of generation STEPS.
void advance(inout Strip strip, inout Tile tile, int y, int from, int to) {
  Row row = loadRow(tile, y, from);
  for (int t = 0; t < STEPS; ++t) {
    // `row` is row y - t of generation t. With it, the neighbourhood of the row above is complete.
    RowSums below = sumsOf(row);
    Row next;
    for (int k = 0; k < WORDS; ++k)
      next.word[k] = nextCells(strip.above[t].word[k], strip.here[t].word[k], below.word[k], strip.alive[t].word[k]);
    strip.above[t] = strip.here[t];
    strip.here[t] = below;
    strip.alive[t] = row;
    row = next;
    if (t + 1 < STEPS) killOutside(row, tile, y - t - 1);
  }
  if (y < tile.top + STEPS) return;
  for (int k = 0; k < TILE_WORDS; ++k) {
    int place = (y - STEPS) * rowWords + tile.first + k;
    uint word = row.word[k] >> 16u | row.word[k + 1] << 16u;
    uint changed = word ^ cellsAt(from + place);
    tile.changed[k] |= changed;
    tile.changedTop[k] |= y < tile.top + 2 * STEPS ? changed : 0u;
    tile.changedBottom[k] |= y >= tile.top + TILE_ROWS ? changed : 0u;
    cells[to + place] = word;
  }
}

Tile computed(uint index, int from, int to) {
  Tile tile;
  int across = tilesAcross();
  int column = int(index) % across;
  tile.first = column * TILE_WORDS;
  // The last row of tiles may overlap the row of tiles before it
  tile.top = min(int(index) / across * TILE_ROWS, size.y - TILE_ROWS);
  tile.leftCells = column == 0 ? 0xffff0000u : 0xffffffffu;
  tile.rightCells = column == across - 1 ? 0xffffu : 0xffffffffu;
  for (int k = 0; k < TILE_WORDS; ++k) tile.changed[k] = tile.changedTop[k] = tile.changedBottom[k] = 0u;
  Strip strip;
  for (int t = 0; t < STEPS; ++t)
    for (int k = 0; k < WORDS; ++k) {
      strip.above[t].word[k] = rowSum(0u, 0u, 0u);
      strip.here[t].word[k] = rowSum(0u, 0u, 0u);
      strip.alive[t].word[k] = 0u;
    }
  // Each iteration processes two rows, to reduce the cost of values carried over the loop.
  for (int y = tile.top - STEPS; y < tile.top + TILE_ROWS + STEPS; y += 2) {
    advance(strip, tile, y, from, to);
    advance(strip, tile, y + 1, from, to);
  }
  return tile;
}

// In the row of tiles of `place`, marks for the next pass the tile at `place` and its neighbours if they read cells
// that have changed here.
void markRow(ivec2 place, uint changed[TILE_WORDS], uint pass) {
  ivec2 count = ivec2(tilesAcross(), tilesDown());
  uint some = 0u;
  for (int k = 0; k < TILE_WORDS; ++k) some |= changed[k];
  if (some == 0u) return;
  int row = (place.y + 2 * count.y) % count.y * count.x;
  marks[row + place.x] = pass;
  if ((changed[0] & (1u << uint(STEPS)) - 1u) != 0u) marks[row + (place.x == 0 ? count.x : place.x) - 1] = pass;
  if (changed[TILE_WORDS - 1] >> uint(32 - STEPS) != 0u) marks[row + (place.x + 1 == count.x ? 0 : place.x + 1)] = pass;
}

void markAround(Tile tile, uint index, uint pass) {
  ivec2 place = ivec2(int(index) % tilesAcross(), int(index) / tilesAcross());
  markRow(place, tile.changed, pass);
#ifdef OVERLAP
  // The last two rows of tiles share cells, so a tile also reads cells of the tile two rows away.
  for (int dy = -2; dy <= 2; ++dy)
    if (dy != 0) markRow(place + ivec2(0, dy), tile.changed, pass);
#else
  markRow(place - ivec2(0, 1), tile.changedTop, pass);
  markRow(place + ivec2(0, 1), tile.changedBottom, pass);
#endif
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  int halfWords = rowWords * size.y;
  for (int i = 0; i < passes; ++i) {
    uint pass = firstPass + uint(i);
    if (lane == 0u) listed = 0u;
    barrier();
    for (uint tile = lane; tile < uint(TILES); tile += 8u)
      if (marks[tile] == pass || (all && i == 0)) list[atomicAdd(listed, 1u)] = tile;
    barrier();
    int from = (pass & 1u) == 0u ? 0 : halfWords;
    uint count = listed;
    for (uint at = lane; at < count; at += 8u) {
      uint tile = list[at];
      markAround(computed(tile, from, halfWords - from), tile, pass + 1u);
    }
    memoryBarrier();
    barrier();
  }
  // Detects a loop that the driver has cut off. The limit of 65,535 iterations applies to the sum over all loops of an
  // invocation, so in that case this loop also ends early.
  int reached = 0;
  for (int i = 0; i <= passes; ++i) ++reached;
  if (reached <= passes) noteLost(firstPass, lane);
}

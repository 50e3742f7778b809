// Many generations in one dispatch by one work group, of tiles only where something moves. A pass is STEPS
// generations; a tile is TILE_WORDS * 32 cells wide and TILE_ROWS high. Every cell of a pass depends on cells at
// most STEPS <= 16 away, so a tile whose neighbourhood (the tiles around it) stood still in the last pass stands
// still in this one: what it holds is its own next state already, in both halves of `cells`. Tiles that change
// mark those near them for the next pass.
//
// For drivers on the CPU: there a dispatch costs 60 to 90 us, a work group of 8 is one vector, and its loops end
// silently after 65,535 iterations: LifeActive in src/sim/life counts them, and the kernel's end notes it where that
// was not enough.
// Defines: BORN and SURVIVE, or FORMULA; TORUS or not; STEPS, TILE_WORDS, TILE_ROWS, TILES; OVERLAP where the height is no
// multiple of TILE_ROWS.
#include "life/bindings.glsl"
layout(local_size_x = 8) in;
layout(r32ui, binding = cellsBinding) uniform coherent readonly uimageBuffer cellTexels;
layout(std430, binding = cellsBinding) coherent writeonly buffer CellBlock { uint cells[]; };
// The pass that a tile is to be computed in.
layout(std430, binding = marksBinding) coherent buffer MarkBlock { uint marks[]; };
uniform ivec2 size;  // cells; width a multiple of TILE_WORDS * 32, height at least TILE_ROWS and STEPS
uniform int rowWords;  // from row to row
uniform uint firstPass;  // reads the half firstPass & 1, writes the other
uniform int passes;
uniform bool all;  // in the first pass, every tile

#include "common/status.glsl"
#define WORD uint
#ifdef FORMULA
#include "life/formula_model.glsl"
#else
#include "life/model.glsl"
#endif

shared uint list[TILES];
shared uint listed;

// A row of a tile with 16 cells beside it on either side.
const int WORDS = TILE_WORDS + 1;
struct Row {
  uint word[WORDS];
};
struct RowSums {
  RowSum word[WORDS];
};
struct Strip {
  RowSums above[STEPS];  // of generation t: two rows back,
  RowSums here[STEPS];   // one row back,
  Row alive[STEPS];      // and that row itself
};
// What a tile is: its first word in a row, its top row, which cells beside it exist, and which of its cells
// changed: in any row, in the first STEPS and in the last STEPS.
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

// Takes in row `y` of generation 0 and stores, once there is one, row y - STEPS of generation STEPS.
void advance(inout Strip strip, inout Tile tile, int y, int from, int to) {
  Row row = loadRow(tile, y, from);
  for (int t = 0; t < STEPS; ++t) {
    // `row` is row y - t of generation t; it completes the neighbours of the row above it.
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
  tile.top = min(int(index) / across * TILE_ROWS, size.y - TILE_ROWS);  // the last ones may overlap
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
  // Two rows an iteration: what is carried from one to the next costs, too.
  for (int y = tile.top - STEPS; y < tile.top + TILE_ROWS + STEPS; y += 2) {
    advance(strip, tile, y, from, to);
    advance(strip, tile, y + 1, from, to);
  }
  return tile;
}

// Marks for the next pass the tiles of one row of them, beside and at `place`, that read cells changed here.
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
  // The last two rows of tiles share cells, so one reads what the second next to it has.
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
  // Where the driver has ended a loop above, this one ends early, too.
  int reached = 0;
  for (int i = 0; i <= passes; ++i) ++reached;
  if (reached <= passes) noteLost(firstPass, lane);
}

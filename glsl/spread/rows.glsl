// Steps cells in elements of sixteen consecutive cells of a row (four words). An invocation moves down a column of
// elements and keeps the rows above and below in registers. Word arithmetic processes four bytes in parallel; the bytes
// hold small numbers, so they never overflow into each other.
#include "common/bindings.glsl"
#include "common/hash.glsl"
#include "common/words.glsl"
#include "spread/bindings.glsl"
#include "spread/cells.glsl"

INPUT_WORDS(cellsBinding, CellBlock, cells)
STATE_WORDS(nextCellsBinding, NextBlock, nextCells)
// Counts for each step since the start, four words per step: number of cells of the classes ready, active and spent,
// and of all other cells.
layout(std430, binding = countsBinding) restrict buffer CountBlock { uint counts[]; };
uniform ivec2 size;      // Number of cells per axis
uniform bool torus;      // True for a torus; false if there are no cells beyond the border
uniform int countPlace;  // Index of this step in `counts`

const uint ones = 0x01010101u;

// Return a word with 1 in each byte whose cell belongs to the class.
uvec4 readyCells(uvec4 state) { return (state >> 6u) & ~(state >> 7u) & ones; }
uvec4 activeCells(uvec4 state) { return (state >> 7u) & ~(state >> 6u) & ones; }
uvec4 spentCells(uvec4 state) { return (state >> 7u) & (state >> 6u) & ones; }

// Returns a word with 1 in each byte that is nonzero, for bytes up to 127.
uvec4 notZero(uvec4 bytes) { return ((bytes + 0x7f7f7f7fu) >> 7u) & ones; }

// Adds one to the age of active and of spent cells, up to 63.
uvec4 aged(uvec4 state) {
  uvec4 old = (state & 0x3f3f3f3fu) + ones;  // Bit 6 is set if the age was 63
  return state + ((state >> 7u) & ~(old >> 6u) & ones);
}

// Packs bytes that hold 0 or 1 into bits: cell k of the element becomes bit k.
uint bitsOf(uvec4 bytes) {
  uvec4 b = (bytes * 0x10204080u) >> 28u;  // The bits 0, 8, 16, 24 move to 28, 29, 30, 31 without overlap
  return b.x | b.y << 4u | b.z << 8u | b.w << 12u;
}

uint byteOf(uvec4 bytes, int k) { return bytes[k >> 2] >> uint(8 * (k & 3)) & 255u; }

void setByte(inout uvec4 bytes, int k, uint value) {
  uint place = uint(8 * (k & 3));
  bytes[k >> 2] = (bytes[k >> 2] & ~(255u << place)) | value << place;
}

// Row of sixteen cells: their states, and for each cell a byte with a bit mask of active cells: 1 for the left
// neighbour, 2 for the cell, 4 for the right neighbour.
struct Row {
  uvec4 state;
  uvec4 near;
};

uvec4 leftActive(Row row) { return row.near & ones; }
uvec4 isActive(Row row) { return row.near >> 1u & ones; }
uvec4 rightActive(Row row) { return row.near >> 2u & ones; }

int rowElements() { return (size.x + 15) >> 4; }

// Column of elements, with the positions of its neighbours, which are the same in each row. The values are copied from
// uniforms because software drivers read uniforms lane by lane; the loop over rows thus reads no uniforms.
struct Column {
  ivec2 size;               // Number of cells of the grid per axis
  int rowElements;
  bool torus;
  int here, left, right;    // Indices of this element, of its left neighbour and of its right neighbour in a row
  uint lastCell;            // Index of the last cell in the left neighbour
  uint hasLeft, hasRight;   // 0 if there are no cells beyond the border
  // If the row ends within this element: 1 in the byte after the row's end, where the row's first cell follows
  uvec4 follows;
};

Column columnOf(int c) {
  int count = rowElements();
  int last = count - 1;
  Column column = Column(size, count, torus, c, c == 0 ? last : c - 1, c == last ? 0 : c + 1,
                         c == 0 ? uint(size.x - 1) & 15u : 15u, c > 0 || torus ? 1u : 0u, c < last || torus ? 1u : 0u,
                         uvec4(0u));
  if (c == last && (size.x & 15) != 0) setByte(column.follows, size.x & 15, 1u);
  return column;
}

// Returns the index of an element in row y.
int placeIn(Column column, int y) { return y * column.rowElements + column.here; }

// Returns the indices of the first cells of an element's four words.
uvec4 cellsOf(Column column, int y) {
  return uint(y) * uint(column.size.x) + uint(16 * column.here) + uvec4(0u, 4u, 8u, 12u);
}

// Loads row y of a column. Beyond the border of a grid that is not a torus, the row is empty.
Row loadRow(Column column, int y) {
  int rows = column.size.y;
  bool beyond = !column.torus && (y < 0 || y >= rows);
  int row = (y < 0 ? y + rows : y >= rows ? y - rows : y) * column.rowElements;
  if (beyond) row = 0;
  Row r;
  r.state = LOAD_INPUT_WORDS(cells, row + column.here);
  uvec4 before = activeCells(LOAD_INPUT_WORDS(cells, row + column.left));
  uint previous = byteOf(before, int(column.lastCell)) & column.hasLeft;
  uint next = activeCells(LOAD_INPUT_WORDS(cells, row + column.right)).x & column.hasRight;
  uvec4 here = activeCells(r.state);
  uvec4 followed = here | column.follows * next;  // Cells after the byte marked in `follows` are always empty.
  uvec4 left = here << 8u | uvec4(previous, here.xyz >> 24u);
  uvec4 right = followed >> 8u | uvec4(followed.yzw << 24u, next << 24u);
  r.near = beyond ? uvec4(0u) : left | here << 1u | right << 2u;
  return r;
}

// Precomputed part of spreadRandom() for a step and a seed: the state of hash3() before it mixes its words.
struct Draw {
  uint y, z, product;
};

Draw drawOf(uint step, uint seed) {
  uint y = step * 1664525u + 1013904223u;
  uint z = seed * 1664525u + 1013904223u;
  return Draw(y, z, y * z);
}

// Returns spreadRandom() for four cells.
uvec4 spreadRandoms(uvec4 cells, Draw draw) {
  uvec4 x = cells * 1664525u + (1013904223u + draw.product);
  uvec4 y = draw.y + draw.z * x;
  uvec4 z = draw.z + x * y;
  return (x ^ x >> 16u) + (y ^ y >> 16u) * (z ^ z >> 16u) >> 1u;
}

#ifndef TEXEL_PATH
shared uint groupCounts[4];
#endif

// Returns the bytewise sum of the four words.
uint sumOfWords(uvec4 words) { return words.x + words.y + words.z + words.w; }

uint sumOfBytes(uint bytes) {
  uint pairs = (bytes & 0x00ff00ffu) + (bytes >> 8u & 0x00ff00ffu);
  return (pairs & 0xffffu) + (pairs >> 16u);
}

// Returns the numbers of cells of the four classes in some rows of a column. The arguments `ready`, `spreading` and
// `spent` are bytewise sums over at most 63 rows.
uvec4 countsOf(Column column, uint ready, uint spreading, uint spent, int rows) {
  uvec4 sums = uvec4(sumOfBytes(ready), sumOfBytes(spreading), sumOfBytes(spent), 0u);
  sums.w = uint(rows * clamp(column.size.x - 16 * column.here, 0, 16)) - sums.x - sums.y - sums.z;
  return sums;
}

// Adds the sums to the counts of the step. All invocations must call it, because it contains barriers.
void count(uvec4 sums) {
#ifdef TEXEL_PATH
  for (int i = 0; i < 4; ++i)
    if (sums[i] != 0u) atomicAdd(counts[4 * countPlace + i], sums[i]);
#else
  if (gl_LocalInvocationIndex < 4u) groupCounts[gl_LocalInvocationIndex] = 0u;
  barrier();
  for (int i = 0; i < 4; ++i)
    if (sums[i] != 0u) atomicAdd(groupCounts[i], sums[i]);
  barrier();
  if (gl_LocalInvocationIndex < 4u)
    atomicAdd(counts[4 * countPlace + int(gl_LocalInvocationIndex)], groupCounts[gl_LocalInvocationIndex]);
#endif
}

// Sixteen cells of a row are one element of four words; an invocation goes down a column of elements and keeps the
// rows above and below in registers. Arithmetic on whole words: bytes hold small numbers that never overflow.
#include "common/bindings.glsl"
#include "common/hash.glsl"
#include "common/words.glsl"
#include "spread/bindings.glsl"
#include "spread/cells.glsl"

INPUT_WORDS(cellsBinding, CellBlock, cells)
STATE_WORDS(nextCellsBinding, NextBlock, nextCells)
// Counts of each step since the start, four words a step: the first three classes with something in them, and the rest.
layout(std430, binding = countsBinding) restrict buffer CountBlock { uint counts[]; };
uniform ivec2 size;      // cells
uniform bool torus;      // else nothing lies beyond the border
uniform int countPlace;  // of this step in `counts`, in steps

const uint ones = 0x01010101u;

// 1 in each byte whose cell is of the class.
uvec4 readyCells(uvec4 state) { return (state >> 6u) & ~(state >> 7u) & ones; }
uvec4 activeCells(uvec4 state) { return (state >> 7u) & ~(state >> 6u) & ones; }
uvec4 spentCells(uvec4 state) { return (state >> 7u) & (state >> 6u) & ones; }

// 1 in each byte that is not zero, for bytes up to 127.
uvec4 notZero(uvec4 bytes) { return ((bytes + 0x7f7f7f7fu) >> 7u) & ones; }

// The age of active and spent cells plus one, up to 63.
uvec4 aged(uvec4 state) {
  uvec4 old = (state & 0x3f3f3f3fu) + ones;  // bit 6: it was 63
  return state + ((state >> 7u) & ~(old >> 6u) & ones);
}

// A bit for each byte, which holds 0 or 1: cell k of the element is bit k.
uint bitsOf(uvec4 bytes) {
  uvec4 b = (bytes * 0x10204080u) >> 28u;  // bits 0, 8, 16, 24 to 28, 29, 30, 31; no two meet
  return b.x | b.y << 4u | b.z << 8u | b.w << 12u;
}

uint byteOf(uvec4 bytes, int k) { return bytes[k >> 2] >> uint(8 * (k & 3)) & 255u; }

void setByte(inout uvec4 bytes, int k, uint value) {
  uint place = uint(8 * (k & 3));
  bytes[k >> 2] = (bytes[k >> 2] & ~(255u << place)) | value << place;
}

// A row of sixteen cells: their states, and in each byte the bits 1, 2 and 4 where the cell to the left, the cell itself
// and the cell to the right is active.
struct Row {
  uvec4 state;
  uvec4 near;
};

uvec4 leftActive(Row row) { return row.near & ones; }
uvec4 isActive(Row row) { return row.near >> 1u & ones; }
uvec4 rightActive(Row row) { return row.near >> 2u & ones; }

int rowElements() { return (size.x + 15) >> 4; }

// A column of elements: the grid, and where it finds what lies beside it, the same in each row. Software drivers read
// every uniform lane by lane, so nothing in the loop over rows reads one.
struct Column {
  ivec2 size;               // of the grid, cells
  int rowElements;
  bool torus;
  int here, left, right;    // elements
  uint lastCell;            // of the element to the left
  uint hasLeft, hasRight;   // 0 where nothing lies beyond the border
  uvec4 follows;            // 1 in the byte where the row ends within this element: its first cell follows there
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

// The place of an element in row y.
int placeIn(Column column, int y) { return y * column.rowElements + column.here; }

// The numbers of an element's first cells in its words.
uvec4 cellsOf(Column column, int y) {
  return uint(y) * uint(column.size.x) + uint(16 * column.here) + uvec4(0u, 4u, 8u, 12u);
}

// Row y of a column; beyond a border that is no torus, nothing.
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
  uvec4 followed = here | column.follows * next;  // cells further on hold nobody
  uvec4 left = here << 8u | uvec4(previous, here.xyz >> 24u);
  uvec4 right = followed >> 8u | uvec4(followed.yzw << 24u, next << 24u);
  r.near = beyond ? uvec4(0u) : left | here << 1u | right << 2u;
  return r;
}

// What spreadRandom() has of step and seed, worked out once: hash3() before its words mix.
struct Draw {
  uint y, z, product;
};

Draw drawOf(uint step, uint seed) {
  uint y = step * 1664525u + 1013904223u;
  uint z = seed * 1664525u + 1013904223u;
  return Draw(y, z, y * z);
}

// spreadRandom() of four cells.
uvec4 spreadRandoms(uvec4 cells, Draw draw) {
  uvec4 x = cells * 1664525u + (1013904223u + draw.product);
  uvec4 y = draw.y + draw.z * x;
  uvec4 z = draw.z + x * y;
  return (x ^ x >> 16u) + (y ^ y >> 16u) * (z ^ z >> 16u) >> 1u;
}

#ifndef TEXEL_PATH
shared uint groupCounts[4];
#endif

// The words' sum, byte by byte.
uint sumOfWords(uvec4 words) { return words.x + words.y + words.z + words.w; }

uint sumOfBytes(uint bytes) {
  uint pairs = (bytes & 0x00ff00ffu) + (bytes >> 8u & 0x00ff00ffu);
  return (pairs & 0xffffu) + (pairs >> 16u);
}

// Cells of the four classes in some rows of a column, where the first three are summed byte by byte over at most 63 rows.
uvec4 countsOf(Column column, uint ready, uint spreading, uint spent, int rows) {
  uvec4 sums = uvec4(sumOfBytes(ready), sumOfBytes(spreading), sumOfBytes(spent), 0u);
  sums.w = uint(rows * clamp(column.size.x - 16 * column.here, 0, 16)) - sums.x - sums.y - sums.z;
  return sums;
}

// Adds to the step's counts. Everyone calls it.
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

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

struct Row {
  uvec4 state;
  uvec4 left, here, right;  // 1 where the cell to the left, the cell itself, the cell to the right is active
};

int rowElements() { return (size.x + 15) >> 4; }

// Row y of column c; beyond a border that is no torus, nothing.
Row loadRow(int c, int y) {
  int width = rowElements();
  bool beyond = !torus && (y < 0 || y >= size.y);
  int row = (y < 0 ? y + size.y : y >= size.y ? y - size.y : y) * width;
  if (beyond) row = 0;
  Row r;
  r.state = LOAD_INPUT_WORDS(cells, row + c);
  uvec4 before = activeCells(LOAD_INPUT_WORDS(cells, row + (c == 0 ? width - 1 : c - 1)));
  uvec4 after = activeCells(LOAD_INPUT_WORDS(cells, row + (c == width - 1 ? 0 : c + 1)));
  r.here = activeCells(r.state);
  uint previous = byteOf(before, c == 0 ? (size.x - 1) & 15 : 15);
  uint next = after.x & 1u;
  if (!torus && c == 0) previous = 0u;
  if (!torus && c == width - 1) next = 0u;
  // Where the row ends within this element, its first cell follows there; cells further on hold nobody.
  uvec4 followed = r.here;
  if (c == width - 1 && (size.x & 15) != 0) setByte(followed, size.x & 15, next);
  r.left = r.here << 8u | uvec4(previous, r.here.xyz >> 24u);
  r.right = followed >> 8u | uvec4(followed.yzw << 24u, next << 24u);
  if (beyond) r.left = r.here = r.right = uvec4(0u);
  return r;
}

#ifndef TEXEL_PATH
shared uint groupCounts[4];
#endif

uint sumOfBytes(uvec4 bytes) {
  uvec4 pairs = (bytes & 0x00ff00ffu) + (bytes >> 8u & 0x00ff00ffu);
  uint total = pairs.x + pairs.y + pairs.z + pairs.w;
  return (total & 0xffffu) + (total >> 16u);
}

// Adds the invocation's cells, summed byte by byte over at most 255 rows, to the step's counts. Everyone calls it.
void count(uvec4 ready, uvec4 spreading, uvec4 spent, int rows, int c) {
  uvec4 sums = uvec4(sumOfBytes(ready), sumOfBytes(spreading), sumOfBytes(spent), 0u);
  sums.w = uint(rows * clamp(size.x - 16 * c, 0, 16)) - sums.x - sums.y - sums.z;
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

// Computes STEPS generations in one pass. An invocation processes BLOCKS * 128 cells of a row and moves down ROWS rows.
// For each generation, it keeps the sums of the two rows above in registers, so every cell is read only once. Only the
// rows at both ends of its strip, and one word to the left and one to the right, are also read by neighbours.
// Generation t + 1 is correct except for t + 1 bits at the outer ends of both additional words, so STEPS can be up to
// 32.
//
// Defines: BORN and SURVIVE, or FORMULA; TORUS for a torus; WHOLE if rows are multiples of BLOCKS * 128 cells (required
// for STEPS > 1, with at least STEPS rows); GROUP_X, GROUP_Y.
#include "common/words.glsl"
#include "life/bindings.glsl"
layout(local_size_x = GROUP_X, local_size_y = GROUP_Y) in;
INPUT_WORDS(cellsBinding, CellBlock, cells)
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;  // Number of cells per axis
uniform int rowBlocks;  // Number of blocks of 128 cells per row

#define WORD uint
#ifdef FORMULA
#include "life/formula_model.glsl"
#else
#include "life/model.glsl"
#endif

const int WORDS = BLOCKS * 4 + 2;  // Number of words, including one additional word on each side

struct Row {
  uint word[WORDS];
};
struct RowSums {
  RowSum word[WORDS];
};

int wrappedRow(int y) {
  y = y < 0 ? y + size.y : (y >= size.y ? y - size.y : y);
  return min(y, size.y - 1);  // Rows far below the last row are loaded but not used
}

// Loads row y of the strip with the adjacent words. y may be up to STEPS rows outside the grid.
Row loadRow(int y, int first) {
  Row row;
  int start = wrappedRow(y) * rowBlocks;
  for (int k = 0; k < BLOCKS; ++k) {
#ifdef WHOLE
    uvec4 block = LOAD_INPUT_WORDS(cells, start + first + k);
#else
    uvec4 block = first + k < rowBlocks ? LOAD_INPUT_WORDS(cells, start + first + k) : uvec4(0u);
#endif
    row.word[4 * k + 1] = block.x;
    row.word[4 * k + 2] = block.y;
    row.word[4 * k + 3] = block.z;
    row.word[4 * k + 4] = block.w;
  }
  bool leftmost = first == 0;
  bool rightmost = first + BLOCKS >= rowBlocks;
  uvec4 left = LOAD_INPUT_WORDS(cells, start + (leftmost ? rowBlocks - 1 : first - 1));
  uint right = LOAD_INPUT_WORDS(cells, start + (rightmost ? 0 : first + BLOCKS)).x;
#ifdef WHOLE
  row.word[0] = left.w;
  row.word[WORDS - 1] = right;
#else
  // Moves the last cell of the row to the position left of the first cell.
  int last = size.x - 1;
  row.word[0] = leftmost ? left[last >> 5 & 3] << uint(31 - (last & 31)) : left.w;
  row.word[WORDS - 1] = right;
#endif
#ifndef TORUS
  if (leftmost) row.word[0] = 0u;
  if (rightmost) row.word[WORDS - 1] = 0u;
  if (y < 0 || y >= size.y)
    for (int k = 0; k < WORDS; ++k) row.word[k] = 0u;
#elif !defined(WHOLE)
  // Copies the first cell of the row to the position right of the last cell, if that position is in the strip.
  int end = size.x - first * 128;
  if (rightmost)
    for (int k = 1; k < WORDS; ++k) row.word[k] |= end >> 5 == k - 1 ? (right & 1u) << uint(end & 31) : 0u;
#endif
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

// Cells beyond a dead border stay dead in the intermediate generations, whatever the rule.
void killOutside(inout Row row, int y, int first) {
#ifndef TORUS
  if (first == 0) row.word[0] = 0u;
  if (first + BLOCKS >= rowBlocks) row.word[WORDS - 1] = 0u;
  if (y < 0 || y >= size.y)
    for (int k = 0; k < WORDS; ++k) row.word[k] = 0u;
#endif
}

void storeRow(Row row, int y, int first) {
  for (int k = 0; k < BLOCKS; ++k) {
    uvec4 block = uvec4(row.word[4 * k + 1], row.word[4 * k + 2], row.word[4 * k + 3], row.word[4 * k + 4]);
#ifndef WHOLE
    // Clears bits beyond the row's end.
    ivec4 left = size.x - (first + k) * 128 - ivec4(0, 32, 64, 96);
    uvec4 some = (uvec4(1u) << uvec4(clamp(left, ivec4(0), ivec4(31)))) - 1u;
    block &= mix(some, uvec4(0xffffffffu), greaterThan(left, ivec4(31)));
    if (first + k < rowBlocks)
#endif
      STORE_WORDS(newCells, y * rowBlocks + first + k, block);
  }
}

void main() {
#ifdef FLAT
  int across = (rowBlocks + BLOCKS - 1) / BLOCKS;
  int strip = int(gl_GlobalInvocationID.x);
  int first = strip % across * BLOCKS;
  int top = strip / across * ROWS;
#else
  int first = int(gl_GlobalInvocationID.x) * BLOCKS;
  int top = int(gl_GlobalInvocationID.y) * ROWS;
#endif
  if (first >= rowBlocks || top >= size.y) return;
  int rows = min(ROWS, size.y - top);
  RowSums above[STEPS];  // Sums of the row two rows above the loaded row, for each generation
  RowSums here[STEPS];   // Sums of the row above the loaded row, for each generation
  Row alive[STEPS];      // Cells of the row above the loaded row, for each generation
  for (int t = 0; t < STEPS; ++t)
    for (int k = 0; k < WORDS; ++k) {
      above[t].word[k] = rowSum(0u, 0u, 0u);
      here[t].word[k] = rowSum(0u, 0u, 0u);
      alive[t].word[k] = 0u;
    }
  for (int i = -STEPS; i < rows + STEPS; ++i) {
    Row row = loadRow(top + i, first);
    for (int t = 0; t < STEPS; ++t) {
      // `row` is row top + i - t of generation t. With it, the neighbourhood of the row above is complete.
      RowSums below = sumsOf(row);
      Row next;
      for (int k = 0; k < WORDS; ++k)
        next.word[k] = nextCells(above[t].word[k], here[t].word[k], below.word[k], alive[t].word[k]);
      above[t] = here[t];
      here[t] = below;
      alive[t] = row;
      row = next;
      if (t + 1 < STEPS) killOutside(row, top + i - t - 1, first);
    }
    if (i >= STEPS) storeRow(row, top + i - STEPS, first);
  }
}

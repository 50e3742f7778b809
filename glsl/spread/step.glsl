// Main function of a step. The including kernel provides
//   Rates ratesNow()   the step's parameters, read once
//   uvec4 stepElement(Rates rates, Column column, int y, Row above, Row here, Row below)   the next sixteen cells
// and on the texel path the functions that tiles.glsl needs.
#ifdef TEXEL_PATH
layout(local_size_x = 8, local_size_y = 1) in;
const int rowsEach = 16;
#else
layout(local_size_x = 8, local_size_y = 16) in;
const int rowsEach = 4;
#endif
#include "spread/tiles.glsl"

void main() {
  int c = int(gl_GlobalInvocationID.x);
  int row = int(gl_GlobalInvocationID.y);
  int first = row * rowsEach;
  int end = c < rowElements() ? min(first + rowsEach, size.y) : first;
  uvec4 counted = uvec4(0u);
  if (first < end) {
    Column column = columnOf(c);
    Rates rates = ratesNow();
#ifdef TEXEL_PATH
    uvec4 before = tileBefore(column, row);
    if (standsStill(rates, column, row, before)) end = first;
    uvec4 changes = uvec4(0u), alone = uvec4(0u), topRow = uvec4(0u), lastRow = uvec4(0u), allRows = uvec4(0u);
#endif
    uint ready = 0u, spreading = 0u, spent = 0u;
    Row above = loadRow(column, first - 1);
    Row here = loadRow(column, first);
    for (int y = first; y < end; ++y) {
      Row below = loadRow(column, y + 1);
      uvec4 next = stepElement(rates, column, y, above, here, below);
      STORE_WORDS(nextCells, placeIn(column, y), next);
      ready += sumOfWords(readyCells(next));
      spreading += sumOfWords(activeCells(next));
      spent += sumOfWords(spentCells(next));
#ifdef TEXEL_PATH
      changes |= here.state ^ next;
      alone |= restlessCells(next);
      lastRow = activeCells(next);
      if (y == first) topRow = lastRow;
      allRows |= lastRow;
#endif
      above = here;
      here = below;
    }
    counted = countsOf(column, ready, spreading, spent, end - first);
#ifdef TEXEL_PATH
    uint flags = edgesOf(column, topRow, lastRow, allRows) | (changes != uvec4(0u) ? changed : 0u) |
                 (alone != uvec4(0u) ? restless : 0u);
    if (first == end) counted = countsOf(before);
    leaveTile(column, row, counted, flags);
    counted -= countsOf(before);  // The counts start from the counts of the last step, so only the difference is added.
#endif
  }
  count(counted);
}

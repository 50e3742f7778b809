// Computes one step. An invocation processes ACROSS elements (two cells each) in each of ROWS rows, from top to bottom.
// The sums of three rows stay in registers, so each element is loaded once per column.
#include "gray_scott/grid.glsl"
layout(local_size_x = GROUP_X, local_size_y = GROUP_Y) in;
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)

struct RowSums {
  vec4 cell[ACROSS];
  vec4 sides[ACROSS];
};

RowSums loadRow(int first, int y) {
  int row = wrappedRow(y);
  RowSums r;
  vec4 left = cellPair(first - 1, row);
  vec4 here = cellPair(first, row);
  for (int i = 0; i < ACROSS; ++i) {
    vec4 right = cellPair(first + i + 1, row);
    r.cell[i] = here;
    r.sides[i] = sideSums(left, here, right);
    left = here;
    here = right;
  }
  return r;
}

void main() {
  int first = int(gl_GlobalInvocationID.x) * ACROSS;
  int top = int(gl_GlobalInvocationID.y) * ROWS;
  if (first >= columns || top >= rowRange.y) return;
  RowSums above = loadRow(first, rowRange.x + top - 1);
  RowSums here = loadRow(first, rowRange.x + top);
  for (int j = 0; j < ROWS; ++j) {
    int y = wrappedRow(rowRange.x + top + j);
    RowSums below = loadRow(first, rowRange.x + top + j + 1);
    for (int i = 0; i < ACROSS; ++i) {
      if (top + j >= rowRange.y || first + i >= columns) continue;
      int element = y * columns + first + i;
      precise vec4 corners = above.sides[i] + below.sides[i];
      precise vec4 edges = here.sides[i] + (above.cell[i] + below.cell[i]);
      STORE_STATE(nextCells, element, steppedPair(here.cell[i], edges, corners, ratesAt(element)));
    }
    above = here;
    here = below;
  }
}

// pass.comp for storage blocks, and so for graphics cards: each flux is made once. A work group of
// 32 columns goes down `rows` rows: an invocation makes the fluxes through the left and the top face of its cells, and
// what it needs of its neighbours passes through shared memory. Strips are 28 columns apart: the outermost ones
// only serve the others.
#define READS_DYE
#include "fluid/grid.glsl"
const int columns = 32;
layout(local_size_x = columns) in;
STATE_ARRAY(nextDyeBinding, NextBlock, nextDye)
uniform int rows;  // of a strip

shared vec4 dyeRow[columns];
shared vec4 leftFluxes[columns];

// A cell, and where it is at the border what of the ring is like it.
void storeDye(int x, int y, vec4 value) {
  STORE_STATE(nextDye, elementOf(x, y), value);
  if (x > 0 && y > 0 && x < size.x - 1 && y < size.y - 1) return;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      int atX = i == 0 ? x : i == 1 ? -1 : size.x;
      int atY = j == 0 ? y : j == 1 ? -1 : size.y;
      if ((i > 0 || j > 0) && insideX(atX) == x && insideY(atY) == y)
        STORE_STATE(nextDye, elementOf(atX, atY), beyondOpen(atX, atY) ? vec4(0.0f) : value);
    }
}

void main() {
  int column = int(gl_LocalInvocationID.x);
  int x = int(gl_WorkGroupID.x) * (columns - 4) + column - 2;
  int top = int(gl_WorkGroupID.y) * rows;
  int end = min(top + rows, size.y);
  bool writes = column >= 2 && column < columns - 2 && x < size.x;
  bool hasFaces = column >= 2 && x <= size.x;
  x = min(x, size.x + 1);
  int before = max(column - 1, 0), twoBefore = max(column - 2, 0), after = min(column + 1, columns - 1);
  // Of the column, from two rows before the present one.
  vec4 a = dyeAt(x, top - 2), b = dyeAt(x, top - 1), c = dyeAt(x, top);
  vec4 left = vec4(0.0f), right = vec4(0.0f), topFlux = vec4(0.0f);
  for (int y = top; y <= end; ++y) {
    vec4 d = dyeAt(x, y + 1);
    vec4 bottomFlux = writes ? dyeFluxes(dyeWay(throughV(x, y)), a, b, c, d) : vec4(0.0f);
    if (writes && y > top) {
      precise vec4 next = b - ((right - left) + (bottomFlux - topFlux));
      storeDye(x, y - 1, next);
    }
    topFlux = bottomFlux;
    dyeRow[column] = c;
    barrier();
    left = hasFaces && y < end ? dyeFluxes(dyeWay(throughU(x, y)), dyeRow[twoBefore], dyeRow[before], c, dyeRow[after])
                               : vec4(0.0f);
    leftFluxes[column] = left;
    barrier();
    right = leftFluxes[after];
    a = b;
    b = c;
    c = d;
  }
}

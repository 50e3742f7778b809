// STEPS steps in one pass. A work group loads a tile with a border as wide as what STEPS steps can reach, keeps
// each invocation's ROWS elements in registers and the tile in shared memory, and stores what the border has not
// spoilt. The order of operations is that of step.comp, so the bits are the same.
#include "gray_scott/grid.glsl"
layout(local_size_x = TILE_X, local_size_y = TILE_Y / ROWS) in;
STATE_ARRAY(1, NextBlock, nextCells)

const int borderX = (STEPS + 1) / 2;  // elements
const int borderY = STEPS;            // rows

shared vec4 tile[TILE_X * TILE_Y];

// For i >= -8 count: % of a negative number is undefined in GLSL.
int wrapped(int i, int count) {
  return (i + 8 * count) % count;
}

vec2 cellAt(int x, int row) {
  int inside = wrapped(x, size.x);
  vec4 pair = LOAD_INPUT(cells, row * columns + (inside >> 1));
  return (inside & 1) == 0 ? pair.xy : pair.zw;
}

// Element x, however far beyond the border: cells 2x and 2x + 1 on the torus.
vec4 pairAnywhere(int x, int y) {
  int row = wrapped(y, size.y);
  if (x >= 0 && x < columns) return LOAD_INPUT(cells, row * columns + x);
  return vec4(cellAt(2 * x, row), cellAt(2 * x + 1, row));
}

vec4 sidesIn(int x, int y, vec4 here) {
  vec2 left = tile[y * TILE_X + max(x - 1, 0)].zw;
  vec2 right = tile[y * TILE_X + min(x + 1, TILE_X - 1)].xy;
  return sideSums(vec4(left, left), here, vec4(right, right));
}

void main() {
  int x = int(gl_LocalInvocationID.x);
  int top = int(gl_LocalInvocationID.y) * ROWS;
  ivec2 origin = ivec2(gl_WorkGroupID.xy) * ivec2(TILE_X - 2 * borderX, TILE_Y - 2 * borderY) -
                 ivec2(borderX, borderY);
  vec4 own[ROWS];
  for (int r = 0; r < ROWS; ++r) {
    own[r] = pairAnywhere(origin.x + x, origin.y + top + r);
    tile[(top + r) * TILE_X + x] = own[r];
  }
  for (int s = 0; s < STEPS; ++s) {
    barrier();
    int over = max(top - 1, 0);
    vec4 aboveCell = tile[over * TILE_X + x];
    vec4 aboveSides = sidesIn(x, over, aboveCell);
    vec4 hereSides = sidesIn(x, top, own[0]);
    for (int r = 0; r < ROWS; ++r) {
      int under = min(top + r + 1, TILE_Y - 1);
      vec4 belowCell = r + 1 < ROWS ? own[min(r + 1, ROWS - 1)] : tile[under * TILE_X + x];
      vec4 belowSides = sidesIn(x, under, belowCell);
      precise vec4 corners = aboveSides + belowSides;
      precise vec4 edges = aboveCell + belowCell;
      edges = hereSides + edges;
      aboveCell = own[r];
      aboveSides = hereSides;
      hereSides = belowSides;
      own[r] = steppedPair(own[r], edges, corners, feedKill.xyxy);
    }
    barrier();
    for (int r = 0; r < ROWS; ++r) tile[(top + r) * TILE_X + x] = own[r];
  }
  int toX = origin.x + x;
  if (x < borderX || x >= TILE_X - borderX || toX >= columns) return;
  for (int r = 0; r < ROWS; ++r) {
    int y = origin.y + top + r;
    bool sound = top + r >= borderY && top + r < TILE_Y - borderY && y < size.y;
    if (sound) STORE_STATE(nextCells, y * columns + toX, own[r]);
  }
}

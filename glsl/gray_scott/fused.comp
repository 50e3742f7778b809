// STEPS steps in one pass. A work group loads a tile with a border as wide as what STEPS steps can reach, keeps
// each invocation's eight elements of a column in registers and the tile in shared memory, and stores what the border
// has not spoilt. The order of operations is that of step.comp, so the bits are the same.
#include "gray_scott/grid.glsl"
layout(local_size_x = TILE_X, local_size_y = TILE_Y / 8) in;
STATE_ARRAY(1, NextBlock, nextCells)

const int borderX = (STEPS + 1) / 2;  // elements
const int borderY = STEPS;            // rows

// The first and the second cell of each element: apart, neighbouring invocations use different banks.
shared vec2 firsts[TILE_X * TILE_Y];
shared vec2 seconds[TILE_X * TILE_Y];

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

// Rows are unrolled by hand: an array indexed by a loop would leave the registers.
#define EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)

void main() {
  int x = int(gl_LocalInvocationID.x);
  int top = int(gl_LocalInvocationID.y) * 8;
  ivec2 useful = ivec2(TILE_X - 2 * borderX, TILE_Y - 2 * borderY);
  ivec2 origin = ivec2(gl_WorkGroupID.xy) * useful + ivec2(-borderX, rowRange.x - borderY);
  int last = rowRange.x + rowRange.y;
  int base = top * TILE_X + x;
  int toLeft = x > 0 ? -1 : 0;
  int toRight = x < TILE_X - 1 ? 1 : 0;
  int over = base - (top > 0 ? TILE_X : 0);
  int under = base + (top + 8 < TILE_Y ? 8 : 7) * TILE_X;
#define MAKE(r) vec4 own##r;
#define LOAD_INSIDE(r) own##r = LOAD_INPUT(cells, first + r * columns);
#define LOAD_ANYWHERE(r) own##r = pairAnywhere(origin.x + x, origin.y + top + r);
#define SHARE(r)                          \
  firsts[base + r * TILE_X] = own##r.xy;  \
  seconds[base + r * TILE_X] = own##r.zw;
#define SIDES(at, here) \
  sideSums(vec4(vec2(0.0f), seconds[(at) + toLeft]), here, vec4(firsts[(at) + toRight], vec2(0.0f)))
// Row r from the sums of the rows above and here; then they move down by one.
#define ROW(r, at, below)                              \
  {                                                    \
    vec4 belowCell = below;                            \
    vec4 belowSides = SIDES(at, belowCell);            \
    precise vec4 corners = aboveSides + belowSides;    \
    precise vec4 edges = aboveCell + belowCell;        \
    edges = hereSides + edges;                         \
    aboveCell = own##r;                                \
    aboveSides = hereSides;                            \
    hereSides = belowSides;                            \
    own##r = steppedPair(own##r, edges, corners, feedKill.xyxy); \
  }
  EACH(MAKE)
  // Eight loads under way at once, where no branch stands between them.
  if (origin.x >= 0 && origin.x + TILE_X <= columns && origin.y >= 0 && origin.y + TILE_Y <= size.y) {
    int first = (origin.y + top) * columns + origin.x + x;
    EACH(LOAD_INSIDE)
  } else {
    EACH(LOAD_ANYWHERE)
  }
  EACH(SHARE)
  for (int s = 0; s < STEPS; ++s) {
    barrier();
    vec4 aboveCell = vec4(firsts[over], seconds[over]);
    vec4 aboveSides = SIDES(over, aboveCell);
    vec4 hereSides = SIDES(base, own0);
    ROW(0, base + TILE_X, own1)
    ROW(1, base + 2 * TILE_X, own2)
    ROW(2, base + 3 * TILE_X, own3)
    ROW(3, base + 4 * TILE_X, own4)
    ROW(4, base + 5 * TILE_X, own5)
    ROW(5, base + 6 * TILE_X, own6)
    ROW(6, base + 7 * TILE_X, own7)
    ROW(7, under, vec4(firsts[under], seconds[under]))
    barrier();
    EACH(SHARE)
  }
  int toX = origin.x + x;
  if (x < borderX || x >= TILE_X - borderX || toX >= columns) return;
#define STORE(r)                                                                       \
  {                                                                                    \
    int y = origin.y + top + r;                                                        \
    bool sound = top + r >= borderY && top + r < TILE_Y - borderY && y < last;         \
    if (sound) STORE_STATE(nextCells, wrappedRow(y) * columns + toX, own##r);          \
  }
  EACH(STORE)
}

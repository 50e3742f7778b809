// Several steps in one pass, as gray_scott/strips.comp has them: invocations go down the rows of a strip; a row that is
// loaded completes the row above it one step later, and so on. Where neighbours can tell each other their values, a strip is
// the 32 invocations of a work group side by side; on the texel path each invocation has a strip of its own.
// The kernel says STEPS, ELEMENTS (of four cells, of an invocation) and STRIP_ROWS.
// Beyond edges that nothing crosses the field is mirrored: column -1 is column 0, -2 is 1. Where stencils are even, as all
// sums are, the cells there step as those that they mirror, bit for bit, so a strip goes on into them.
#ifdef TEXEL_PATH
const int neighbours = 1;
int lane = 0;
#else
const int neighbours = 32;
int lane = int(gl_LocalInvocationID.x);
#endif
const int border = (STEPS + 3) / 4;                     // elements
const int inside = neighbours * ELEMENTS - 2 * border;  // of a strip that are stored

// The last cell of the invocation to the left and the first of the one to the right; at the strip's ends anything.
#ifdef TEXEL_PATH
vec2 beside(float first, float last) {
  return vec2(first, last);
}
#elif defined(SUBGROUPS)
vec2 beside(float first, float last) {
  return vec2(subgroupShuffleUp(last, 1u), subgroupShuffleDown(first, 1u));
}
#else
shared float firsts[2][32];
shared float lasts[2][32];
int turn = 0;  // two in turn, so that one barrier is enough

vec2 beside(float first, float last) {
  firsts[turn][lane] = first;
  lasts[turn][lane] = last;
  barrier();
  vec2 there = vec2(lasts[turn][max(lane - 1, 0)], firsts[turn][min(lane + 1, 31)]);
  turn = 1 - turn;
  return there;
}
#endif

// For i >= -16 count: % of a negative number is undefined in GLSL.
int wrapped(int i, int count) {
  return (i + 16 * count) % count;
}

// Of those beyond edges: which one stands there, and whether it faces the other way. `unfolded` counts through the grid and,
// where it is mirrored, through it back.
#if BOUNDARY == 1
const int folds = 2;
#else
const int folds = 1;
#endif
int folded(int unfolded, int count) {
  return unfolded < count ? unfolded : 2 * count - 1 - unfolded;
}
vec4 facing(vec4 cells, bool back) {
#if BOUNDARY == 1
  return back ? cells.wzyx : cells;
#else
  return cells;
#endif
}

// The lowest cell that is lost in each step of a frame; lost.comp tells which was first.
layout(std430, binding = sumBinding) restrict buffer LostBlock { uint lostCells[]; };
uniform int lostFirst;  // number of the first of these steps

// Of four cells' exponents (exponentOf), in `row` after step `level` of the pass.
void noteStrip(int bits, int x, int row, int level) {
  if (bits < lostBits) return;
  int who = 31 - (bits & 31);
  atomicMin(lostCells[stepNumber - lostFirst + level], uint(((who >> 2) * size.y + row) * size.x + 4 * x + (who & 3)));
}

// Computes several steps in one pass, like gray_scott/strips.comp. Invocations move down the rows of a strip. Each
// loaded row completes the row above it one step later, and so on. On GPUs, a strip is processed by the 32 invocations
// of a workgroup, which exchange values; on the texel path, each invocation processes a separate strip. The kernel
// defines STEPS, ELEMENTS (elements of four cells per invocation) and STRIP_ROWS.
//
// With the no-flux boundary, the field is mirrored beyond the edges: column -1 equals column 0, and column -2 equals
// column 1. All sums are symmetric stencils, so a mirrored cell gets the same bits in a step as its original, and a
// strip continues into the mirrored cells.
#ifdef TEXEL_PATH
const int neighbours = 1;
int lane = 0;
#else
const int neighbours = 32;
int lane = int(gl_LocalInvocationID.x);
#endif
const int border = (STEPS + 3) / 4;                     // Width of the border of a strip, in elements
const int inside = neighbours * ELEMENTS - 2 * border;  // Number of elements of a strip that are stored

// Returns the last cell of the invocation to the left and the first cell of the invocation to the right. At the ends of
// the strip, the values are arbitrary.
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
int turn = 0;  // Index of the half of the double buffer that is written next; with two halves, one barrier per exchange
               // is enough

vec2 beside(float first, float last) {
  firsts[turn][lane] = first;
  lasts[turn][lane] = last;
  barrier();
  vec2 there = vec2(lasts[turn][max(lane - 1, 0)], firsts[turn][min(lane + 1, 31)]);
  turn = 1 - turn;
  return there;
}
#endif

// Returns i wrapped to 0 .. count - 1, for i >= -16 count. The offset is needed because % of a negative number is
// undefined in GLSL.
int wrapped(int i, int count) {
  return (i + 16 * count) % count;
}

// Mapping of indices beyond the edges. `unfolded` counts forwards through the grid and, for a mirrored boundary, back
// through it. folded() returns the cell. facing() reverses the order of the four cells of an element on the way back.
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

// For each step of a frame, the lowest index of a lost cell; lost.comp finds the first step with a lost cell.
layout(std430, binding = sumBinding) restrict buffer LostBlock { uint lostCells[]; };
uniform int lostFirst;  // Step number that belongs to lostCells[0]

// Records lost cells, given the exponents of four cells (exponentOf) in `row` after step `level` of the pass.
void noteStrip(int bits, int x, int row, int level) {
  if (bits < lostBits) return;
  int cellInRow = 31 - (bits & 31);
  atomicMin(lostCells[stepNumber - lostFirst + level], uint(((cellInRow >> 2) * size.y + row) * size.x + 4 * x + (cellInRow & 3)));
}

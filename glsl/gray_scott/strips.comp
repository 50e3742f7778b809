// Computes STEPS steps in one pass. An invocation moves down STRIP_ROWS rows of a strip with ELEMENTS elements per row.
// Each loaded row completes the row above it one step later, which in turn completes the row above that another step
// later, and so on. A pass therefore keeps only two rows per step in registers. It recomputes only the strip's sides
// and its first and last 2 * STEPS rows. The operations have the same order as in step.comp, so the bits are the same.
//
// On GPUs, a strip is processed by the 32 invocations of a workgroup, which exchange values. On the texel path, each
// invocation processes a separate strip, including the strip's sides.
#ifdef SUBGROUPS
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#endif
#include "gray_scott/grid.glsl"
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)

#ifdef TEXEL_PATH
layout(local_size_x = 8) in;
const int neighbours = 1;
int lane = 0;
#else
layout(local_size_x = 32) in;
const int neighbours = 32;
int lane = int(gl_LocalInvocationID.x);
#endif
const int border = (STEPS + 1) / 2;                     // Width of the border of a strip, in elements
const int inside = neighbours * ELEMENTS - 2 * border;  // Number of elements of a strip that are stored

// Elements of one row that an invocation processes.
struct Row {
  vec4 element[ELEMENTS];
};

// Last two rows of one step, with the sums of the left and right neighbours.
struct Level {
  Row above, aboveSides, here, hereSides;
};

// Gets the last cell of the invocation to the left and the first cell of the invocation to the right. At the ends of
// the strip, the results are arbitrary.
#ifdef TEXEL_PATH
void exchange(vec2 first, vec2 last, out vec2 left, out vec2 right) {
  left = first;
  right = last;
}
#elif defined(SUBGROUPS)
void exchange(vec2 first, vec2 last, out vec2 left, out vec2 right) {
  left = subgroupShuffleUp(last, 1u);
  right = subgroupShuffleDown(first, 1u);
}
#else
shared vec2 firsts[2][32];
shared vec2 lasts[2][32];
int turn = 0;  // Index of the half of the double buffer that is written next; with two halves, one barrier per exchange
               // is enough

void exchange(vec2 first, vec2 last, out vec2 left, out vec2 right) {
  firsts[turn][lane] = first;
  lasts[turn][lane] = last;
  barrier();
  left = lasts[turn][max(lane - 1, 0)];
  right = firsts[turn][min(lane + 1, 31)];
  turn = 1 - turn;
}
#endif

Row sidesOf(Row row) {
  const int last = ELEMENTS - 1;
  vec2 left, right;
  exchange(row.element[0].xy, row.element[last].zw, left, right);
  Row sides;
  for (int k = 0; k <= last; ++k)
    sides.element[k] = sideSums(k > 0 ? row.element[max(k - 1, 0)] : vec4(0, 0, left), row.element[k],
                                k < last ? row.element[min(k + 1, last)] : vec4(right, 0, 0));
  return sides;
}

// Adds the row below and returns the row `here` one step later.
Row advanced(inout Level level, Row below) {
  Row belowSides = sidesOf(below);
  Row next;
  for (int k = 0; k < ELEMENTS; ++k) {
    precise vec4 corners = level.aboveSides.element[k] + belowSides.element[k];
    precise vec4 edges = level.hereSides.element[k] + (level.above.element[k] + below.element[k]);
    next.element[k] = steppedPair(level.here.element[k], edges, corners, ratesAt(0));
  }
  level.above = level.here;
  level.aboveSides = level.hereSides;
  level.here = below;
  level.hereSides = belowSides;
  return next;
}

// Returns i wrapped to 0 .. count - 1, for i >= -16 count. The offset is needed because % of a negative number is
// undefined in GLSL.
int wrapped(int i, int count) {
  return (i + 16 * count) % count;
}

// Location of the two cells of an element that may be far beyond the border: the elements within a row, and which half
// of the element each cell is.
struct Source {
  int first, second;
  bool firstHalf, secondHalf;  // True if the cell is the first of its element
};

Source sourceOf(int x) {
  if (x >= 0 && x < columns) return Source(x, x, false, true);
  int first = wrapped(2 * x, size.x);
  int second = wrapped(2 * x + 1, size.x);
  return Source(first >> 1, second >> 1, (first & 1) == 1, (second & 1) == 1);
}

vec4 loadPair(Source source, int start) {
  vec4 pair = LOAD_INPUT(cells, start + source.first);
#ifdef ODD_WIDTH
  // The two cells of an element beyond the border may be stored in two different elements.
  vec4 other = pair;
  if (source.second != source.first) other = LOAD_INPUT(cells, start + source.second);
  pair = vec4(source.firstHalf ? pair.zw : pair.xy, source.secondHalf ? other.zw : other.xy);
#endif
  return pair;
}

Row loadRow(Source sources[ELEMENTS], int row) {
  Row loaded;
  for (int k = 0; k < ELEMENTS; ++k) loaded.element[k] = loadPair(sources[k], row * columns);
  return loaded;
}

void main() {
#ifdef TEXEL_PATH
  int strip = int(gl_GlobalInvocationID.x);
#else
  int strip = int(gl_WorkGroupID.x);
#endif
  int x = strip * inside - border + lane * ELEMENTS;
  int top = rowRange.x + int(gl_WorkGroupID.y) * STRIP_ROWS;
  int count = min(STRIP_ROWS, rowRange.x + rowRange.y - top) + 2 * STEPS;
  int row = wrapped(top - STEPS, size.y);
  int to = top - 2 * STEPS;
#ifdef TEXEL_PATH
  if (x + border >= columns) return;
#endif
  Source sources[ELEMENTS];
  bool sound[ELEMENTS];
  Row nothing;
  for (int k = 0; k < ELEMENTS; ++k) {
    int place = lane * ELEMENTS + k;
    sources[k] = sourceOf(x + k);
    sound[k] = place >= border && place < border + inside && x + k < columns;
    nothing.element[k] = vec4(0);
  }
  Level empty = Level(nothing, nothing, nothing, nothing);

#if STEPS == 2
#define EACH(DO) DO(0) DO(1)
#elif STEPS == 3
#define EACH(DO) DO(0) DO(1) DO(2)
#elif STEPS == 4
#define EACH(DO) DO(0) DO(1) DO(2) DO(3)
#elif STEPS == 6
#define EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5)
#else
#define EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#endif
#define MAKE(s) Level level##s = empty;
#define ADVANCE(s) next = advanced(level##s, next);
// Loads the next row while the current row is computed.
#define ROW(i)                                                        \
  {                                                                   \
    Row next = pending;                                               \
    row = row + 1 < size.y ? row + 1 : 0;                             \
    pending = loadRow(sources, row);                                           \
    EACH(ADVANCE)                                                     \
    if ((i) >= 2 * STEPS && (i) < count) {                            \
      int start = wrappedRow(to + (i)) * columns;                     \
      for (int k = 0; k < ELEMENTS; ++k)                              \
        if (sound[k]) STORE_STATE(nextCells, start + x + k, next.element[k]); \
    }                                                                 \
  }
  EACH(MAKE)
  Row pending = loadRow(sources, row);
  // Each iteration processes three rows, so that the roles of the registers rotate without copies.
  for (int i = 0; i < count; i += 3) {
    ROW(i)
    ROW(i + 1)
    ROW(i + 2)
  }
}

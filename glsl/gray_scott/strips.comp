// STEPS steps in one pass, without a tile: the 32 invocations of a work group lie side by side across a strip, PAIRS
// elements each, and go down STRIP_ROWS rows of it. A row that is loaded completes the row above it one step later, which
// completes the row above that another step later, and so on, so a pass keeps two rows of each step in registers and
// repeats only the strip's sides and its first and last 2 * STEPS rows. The order of operations is that of step.comp,
// so the bits are the same.
#ifdef SUBGROUPS
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#endif
#include "gray_scott/grid.glsl"
layout(local_size_x = 32) in;
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)

const int border = (STEPS + 1) / 2;  // elements
int lane = int(gl_LocalInvocationID.x);

// The elements of an invocation in a row.
struct Row {
  vec4 first;
#if PAIRS == 2
  vec4 second;
#endif
};

// The last two rows of one step, with the sums of their side neighbours.
struct Level {
  Row above, aboveSides, here, hereSides;
};

// The last cell of the invocation to the left and the first of the one to the right; at the group's ends anything.
#ifdef SUBGROUPS
void exchange(vec2 first, vec2 last, out vec2 left, out vec2 right) {
  left = subgroupShuffleUp(last, 1u);
  right = subgroupShuffleDown(first, 1u);
}
#else
shared vec2 firsts[2][32];
shared vec2 lasts[2][32];
int turn = 0;  // two in turn, so that one barrier is enough

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
  vec2 left, right;
  Row sides;
#if PAIRS == 2
  exchange(row.first.xy, row.second.zw, left, right);
  sides.first = sideSums(vec4(0, 0, left), row.first, row.second);
  sides.second = sideSums(row.first, row.second, vec4(right, 0, 0));
#else
  exchange(row.first.xy, row.first.zw, left, right);
  sides.first = sideSums(vec4(0, 0, left), row.first, vec4(right, 0, 0));
#endif
  return sides;
}

vec4 nextPair(vec4 above, vec4 aboveSides, vec4 here, vec4 hereSides, vec4 below, vec4 belowSides) {
  precise vec4 corners = aboveSides + belowSides;
  precise vec4 edges = hereSides + (above + below);
  return steppedPair(here, edges, corners, ratesAt(0));
}

// Takes the row below and gives the row here one step later.
Row advanced(inout Level level, Row below) {
  Row belowSides = sidesOf(below);
  Row next;
  next.first = nextPair(level.above.first, level.aboveSides.first, level.here.first, level.hereSides.first,
                        below.first, belowSides.first);
#if PAIRS == 2
  next.second = nextPair(level.above.second, level.aboveSides.second, level.here.second,
                         level.hereSides.second, below.second, belowSides.second);
#endif
  level.above = level.here;
  level.aboveSides = level.hereSides;
  level.here = below;
  level.hereSides = belowSides;
  return next;
}

// For i >= -16 count: % of a negative number is undefined in GLSL.
int wrapped(int i, int count) {
  return (i + 16 * count) % count;
}

// Where the two cells of an element lie, however far beyond the border: elements of a row, and which half.
struct Source {
  int first, second;
  bool firstHalf, secondHalf;  // true: the element's second cell
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
  // The halves of an element beyond the border lie in two.
  vec4 other = pair;
  if (source.second != source.first) other = LOAD_INPUT(cells, start + source.second);
  pair = vec4(source.firstHalf ? pair.zw : pair.xy, source.secondHalf ? other.zw : other.xy);
#endif
  return pair;
}

void main() {
  int x = int(gl_WorkGroupID.x) * (32 * PAIRS - 2 * border) - border + lane * PAIRS;
  int top = rowRange.x + int(gl_WorkGroupID.y) * STRIP_ROWS;
  int count = min(STRIP_ROWS, rowRange.x + rowRange.y - top) + 2 * STEPS;
  int row = wrapped(top - STEPS, size.y);
  int to = top - 2 * STEPS;
  Source firstSource = sourceOf(x);
  bool firstSound = lane * PAIRS >= border && lane * PAIRS < 32 * PAIRS - border && x < columns;
#if PAIRS == 2
  Source secondSource = sourceOf(x + 1);
  bool secondSound = lane * PAIRS + 1 >= border && lane * PAIRS + 1 < 32 * PAIRS - border && x + 1 < columns;
#define LOAD(row) Row(loadPair(firstSource, (row) * columns), loadPair(secondSource, (row) * columns))
#define STORE_SECOND(start) \
  if (secondSound) STORE_STATE(nextCells, (start) + x + 1, next.second);
  const Row nothing = Row(vec4(0), vec4(0));
#else
#define LOAD(row) Row(loadPair(firstSource, (row) * columns))
#define STORE_SECOND(start)
  const Row nothing = Row(vec4(0));
#endif
  const Level empty = Level(nothing, nothing, nothing, nothing);

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
// The row after is under way while this one is computed.
#define ROW(i)                                                        \
  {                                                                   \
    Row next = pending;                                               \
    row = row + 1 < size.y ? row + 1 : 0;                             \
    pending = LOAD(row);                                              \
    EACH(ADVANCE)                                                     \
    if ((i) >= 2 * STEPS && (i) < count) {                            \
      int start = wrappedRow(to + (i)) * columns;                     \
      if (firstSound) STORE_STATE(nextCells, start + x, next.first);  \
      STORE_SECOND(start)                                             \
    }                                                                 \
  }
  EACH(MAKE)
  Row pending = LOAD(row);
  // Three rows a round: what is above comes to lie where it was, so nothing is copied.
  for (int i = 0; i < count; i += 3) {
    ROW(i)
    ROW(i + 1)
    ROW(i + 2)
  }
}

// Variant of pass.comp for storage buffers, used on GPUs: each flux is computed only once, and PASSES passes run in one
// dispatch. A workgroup of 32 invocations moves down a strip of `rows` rows; each invocation has two columns. Values of
// neighbouring columns come from the neighbouring invocations' registers (if SUBGROUPS is defined) or through shared
// memory. Values of the rows above and below stay in registers. Each pass runs two rows behind the previous pass. The
// outermost columns, two per pass, serve only as neighbours. Dye is counted in quanta (model.glsl), so a flux is an
// integer. The distance that dye moves through each face is the same in all passes of a step and comes from check.comp.
// Rows are skipped when the strip has had no dye for several rows.
#ifdef SUBGROUPS
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#extension GL_KHR_shader_subgroup_vote : require
#endif
#define READS_DYE
#define NEXT_DYE
#include "fluid/grid.glsl"
const int lanes = 32, columns = 2 * lanes, margin = 2 * PASSES;
layout(local_size_x = lanes) in;
layout(std430, binding = carriedBinding) readonly restrict buffer WayBlock { vec2 ways[]; };
uniform int rows;  // Number of rows of a strip

#if !defined SUBGROUPS || PASSES > 1
shared vec3 firsts[lanes], seconds[lanes];  // Values of both columns of a row
#endif

// Return the value of the invocation to the left (ofLeft) or to the right (ofRight). At the ends of the strip, the
// result is undefined.
#ifdef SUBGROUPS
vec3 ofLeft(int lane, vec3 value) {
  return subgroupShuffleUp(value, 1u);
}

vec3 ofRight(int lane, vec3 value) {
  return subgroupShuffleDown(value, 1u);
}
#else
vec3 ofLeft(int lane, vec3 value) {
  barrier();
  seconds[lane] = value;
  barrier();
  return seconds[max(lane - 1, 0)];
}

vec3 ofRight(int lane, vec3 value) {
  barrier();
  firsts[lane] = value;
  barrier();
  return firsts[min(lane + 1, lanes - 1)];
}
#endif

// Returns true if a row of the strip has no dye.
#ifndef SUBGROUPS
shared uint dyed;
#endif
bool isClear(int lane, vec3 first, vec3 second) {
  uvec3 bits = floatBitsToUint(first) | floatBitsToUint(second);
  uint any = bits.x | bits.y | bits.z;
#ifdef SUBGROUPS
  return subgroupAll(any == 0u);
#else
  barrier();
  if (lane == 0) dyed = 0u;
  barrier();
  if (any != 0u) dyed = 1u;
  barrier();
  return dyed == 0u;
#endif
}

// State of a pass in one column: the current row (`here`), the row above, half the slope along y of the row above, the
// flux through the upper face of the row above, the loss of the row above to both sides, and the difference `up`
// between the two rows.
struct Pass {
  vec3 here, above, slopeAbove, fromAbove, sidesAbove, up;
};

// Returns limitedHalfSlope() for integers. On GPUs, min has half the throughput of a product, so a clamped product of
// the differences is used: it is 1 if both have the same sign, otherwise 0.
vec3 halfSlopes(vec3 before, vec3 after) {
  precise vec3 product = before * after;
  vec3 same = clamp(product, vec3(0.0), vec3(1.0));
  precise vec3 maximum = min(abs(before), abs(after)) * same;
  precise vec3 quarter = 0.25 * (before + after);
  return clamp(quarter, -maximum, maximum);
}

// Returns the flux through a face, in dye quanta.
vec3 unitsThrough(float way, vec3 before, vec3 after, vec3 step_, vec3 slopeBefore, vec3 slopeAfter) {
  bool on = way > 0.0;
  float back = on ? 0.0 : 1.0;
  precise float distance = 1.0 - abs(way);
  float far = on ? distance : -distance;
  precise vec3 from = before + back * step_;
  vec3 slope = on ? slopeBefore : slopeAfter;
  precise vec3 amount = way * (from + far * slope);
  return trunc(amount);
}

int turned(int i, int count) {
  return (i + 8 * count) % count;
}

// Returns the column that stores the dye, velocities and faces of column x, which may be outside the grid.
int columnOf(int x) {
  return leftKind == periodicSide ? turned(x, size.x) : clamp(x, -1, size.x);
}

int rowOf(int y) {
  return topKind == periodicSide ? turned(y, size.y) : clamp(y, -1, size.y);
}

vec3 loadUnits(int x, int y) {
  precise vec3 units = LOAD_CELL(dye, elementOf(x, y)).xyz * perDyeUnit;
  return units;
}

// Returns the distances that dye moves through the left face and the top face of a cell. Beyond the ring, the result is
// arbitrary and is not used.
vec2 waysAt(int x, int y) {
  return ways[elementOf(clamp(x, -1, size.x), clamp(y, -1, size.y))];
}

// Stores a cell. If the cell is at the border, also stores its copies in the ring.
void storeUnits(int x, int y, vec3 units) {
  precise vec3 amounts = units * dyeUnit;
  vec4 value = vec4(amounts, 0.0);
  storeDye(elementOf(x, y), value);
  if (x > 0 && y > 0 && x < size.x - 1 && y < size.y - 1) return;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      int atX = i == 0 ? x : i == 1 ? -1 : size.x;
      int atY = j == 0 ? y : j == 1 ? -1 : size.y;
      if ((i > 0 || j > 0) && insideX(atX) == x && insideY(atY) == y)
        storeDye(elementOf(atX, atY), beyondOpen(atX, atY) ? vec4(0.0f) : value);
    }
}

// Advances a pass by one row. On input, `first` and `second` hold the next row below; on output, they hold the row
// above after the pass. `through_` holds the distances through the faces of both columns in the current row.
void advance(int lane, inout Pass a, inout Pass b, vec4 through_, inout vec3 first, inout vec3 second) {
  vec3 left = ofLeft(lane, b.here), right = ofRight(lane, a.here);
  precise vec3 before_ = a.here - left;
  precise vec3 between_ = b.here - a.here;
  precise vec3 after_ = right - b.here;
  vec3 slopeA = halfSlopes(before_, between_), slopeB = halfSlopes(between_, after_);
  vec3 fromLeft = unitsThrough(through_.x, left, a.here, before_, ofLeft(lane, slopeB), slopeA);
  vec3 middle = unitsThrough(through_.z, a.here, b.here, between_, slopeA, slopeB);
  vec3 toRight = ofRight(lane, fromLeft);
  vec3 upA = a.up;
  precise vec3 onA = first - a.here;
  vec3 upB = b.up;
  precise vec3 onB = second - b.here;
  vec3 downA = halfSlopes(upA, onA), downB = halfSlopes(upB, onB);
  vec3 fluxA = unitsThrough(through_.y, a.above, a.here, upA, a.slopeAbove, downA);
  vec3 fluxB = unitsThrough(through_.w, b.above, b.here, upB, b.slopeAbove, downB);
  precise vec3 outA = a.above - (a.sidesAbove + (fluxA - a.fromAbove));
  precise vec3 outB = b.above - (b.sidesAbove + (fluxB - b.fromAbove));
  precise vec3 sidesA = middle - fromLeft;
  precise vec3 sidesB = toRight - middle;
  a = Pass(first, a.here, downA, fluxA, sidesA, onA);
  b = Pass(second, b.here, downB, fluxB, sidesB, onB);
  first = outA;
  second = outB;
}

#if PASSES > 1
// After the first pass, sets the columns beyond a side that is not periodic: they become copies of the nearest column
// inside, or 0 beyond an open side.
void spread(int lane, ivec2 x, inout vec3 first, inout vec3 second) {
  int from = x.x - 2 * lane;  // First column of the strip
  barrier();
  firsts[lane] = first;
  seconds[lane] = second;
  barrier();
  for (int k = 0; k < 2; ++k) {
    int column = k == 0 ? x.x : x.y;
    if (column >= 0 && column < size.x) continue;
    int inside = clamp(clamp(column, 0, size.x - 1) - from, 0, columns - 1);
    vec3 value = (inside & 1) == 0 ? firsts[inside >> 1] : seconds[inside >> 1];
    if ((column < 0 ? leftKind : rightKind) == openSide) value = vec3(0.0);
    if (k == 0)
      first = value;
    else
      second = value;
  }
}
#endif

void main() {
  int lane = int(gl_LocalInvocationID.x);
  int from = int(gl_WorkGroupID.x) * (columns - 2 * margin) - margin;
  ivec2 x = ivec2(from + 2 * lane, from + 2 * lane + 1);
  int top = int(gl_WorkGroupID.y) * rows;
  int end = min(top + rows, size.y);
  ivec2 at = ivec2(columnOf(x.x), columnOf(x.y));  // Columns that store the dye of this invocation's columns
  bool closes = leftKind == periodicSide;
  ivec2 faces = closes ? at : x;
  bvec2 writes = bvec2(2 * lane >= margin && 2 * lane < columns - margin && x.x < size.x,
                       2 * lane >= margin && 2 * lane < columns - margin && x.y < size.x);
  Pass a[PASSES], b[PASSES];
  vec4 through_[2 * PASSES - 1];  // Distances through faces, for the current row and the rows above it
  Pass none = Pass(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  for (int i = 0; i < PASSES; ++i) a[i] = b[i] = none;
  for (int i = 0; i < 2 * PASSES - 1; ++i) through_[i] = vec4(0.0);
  int start = top - margin;
  a[0].above = loadUnits(at.x, rowOf(start));
  b[0].above = loadUnits(at.y, rowOf(start));
  a[0].here = loadUnits(at.x, rowOf(start + 1));
  b[0].here = loadUnits(at.y, rowOf(start + 1));
  precise vec3 stepA = a[0].here - a[0].above;
  precise vec3 stepB = b[0].here - b[0].above;
  a[0].up = stepA;
  b[0].up = stepB;
  // A pass depends on four rows and on the incoming row, so after five rows without dye it has nothing to move.
  const int pastRows = 5;
  int clear = 0;  // Number of consecutive rows without dye, up to the incoming row
  bool atSide = !closes && (from < 0 || from + columns > size.x);
  for (int y = start + 1; y < end + margin - 1; ++y) {
    int below = rowOf(y + 1);
    vec3 first = loadUnits(at.x, below), second = loadUnits(at.y, below);
    int row = topKind == periodicSide ? turned(y, size.y) : y;
#if PASSES > 1
    for (int i = 2 * PASSES - 2; i > 0; --i) through_[i] = through_[i - 1];
#endif
    clear = isClear(lane, first, second) ? clear + 1 : 0;
    through_[0] = vec4(0.0);
    if (clear < pastRows) {
      through_[0] = vec4(waysAt(faces.x, row), waysAt(faces.y, row));
      advance(lane, a[0], b[0], through_[0], first, second);
    }
#if PASSES > 1
    if (clear < 2 * pastRows - 1) {
      // The second pass, for row y - 1. Rows beyond the sides are set like columns (see spread()).
      if (atSide) spread(lane, x, first, second);
      if (topKind != periodicSide && y - 1 <= 0) {
        bool empty = topKind == openSide;
        a[1].here = a[1].above = empty ? vec3(0.0) : first;
        a[1].up = b[1].up = vec3(0.0);
        b[1].here = b[1].above = empty ? vec3(0.0) : second;
      }
      if (topKind != periodicSide && y - 1 >= size.y) {
        bool empty = bottomKind == openSide;
        first = empty ? vec3(0.0) : a[1].here;
        second = empty ? vec3(0.0) : b[1].here;
      }
      advance(lane, a[1], b[1], through_[2], first, second);
    }
#endif
    int done = y + 1 - 2 * PASSES;
    if (done >= top && done < end) {
      if (writes.x) storeUnits(x.x, done, first);
      if (writes.y) storeUnits(x.y, done, second);
    }
  }
}

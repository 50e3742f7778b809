// Boxes of a hierarchy, and their intersection with rays. Compiles as GLSL and as C++.
// A box is quantized to a grid of 32,768 cells along each axis of the scene, and is at least one cell larger than its
// contents on each side. A ray crosses the plane q of the grid at the distance q a + c, which is monotonic in q even
// after rounding. A ray therefore never reaches the contents before the box, whatever the rounding, so the order in
// which boxes are visited cannot change the result.
#ifndef EXACT_RAY_BOX
#define EXACT_RAY_BOX
#include "common/exact.glsl"

// Quantization grid: corner of cell 0, and size of a cell (m).
struct RayGrid {
  vec3 low;
  vec3 cell;
};

FUNCTION RayGrid rayGrid(vec3 low, vec3 high) {
  precise vec3 size = high - low;
  float maximum = max(max(size.x, max(size.y, size.z)), 1e-6f);
  precise float minimum = maximum * 1e-4f;
  precise vec3 cell = max(size, vec3(minimum)) * 3.0521e-5f;  // 1 / 32764: the scene spans 32,764 of the 32,768 cells
  precise vec3 first = low - cell * 1.5f;
  RayGrid grid;
  grid.low = first;
  grid.cell = cell;
  return grid;
}

FUNCTION vec3 perCell(RayGrid grid) {
  return vec3(exactReciprocal(grid.cell.x), exactReciprocal(grid.cell.y), exactReciprocal(grid.cell.z));
}

FUNCTION uvec3 asCells(vec3 cells) {
  vec3 held = clamp(cells, vec3(0.0f), vec3(32767.0f));
  return uvec3(uint(int(held.x)), uint(int(held.y)), uint(int(held.z)));
}

// Returns the box in three words: low x and y; low z and high x; high y and z.
FUNCTION uvec3 packedBox(RayGrid grid, vec3 low, vec3 high) {
  vec3 per = perCell(grid);
  precise vec3 lowCell = (low - grid.low) * per;
  precise vec3 highCell = (high - grid.low) * per;
  precise vec3 from = floor(lowCell) - 1.0f;
  precise vec3 to = floor(highCell) + 2.0f;
  uvec3 a = asCells(from), b = asCells(to);
  return uvec3(a.x | a.y << 16, a.z | b.x << 16, b.y | b.z << 16);
}
FUNCTION uvec3 joinedBox(uvec3 a, uvec3 b) {
  uint lowX = min(a.x & 0x7fffu, b.x & 0x7fffu), lowY = min(a.x >> 16 & 0x7fffu, b.x >> 16 & 0x7fffu);
  uint lowZ = min(a.y & 0x7fffu, b.y & 0x7fffu), highX = max(a.y >> 16 & 0x7fffu, b.y >> 16 & 0x7fffu);
  uint highY = max(a.z & 0x7fffu, b.z & 0x7fffu), highZ = max(a.z >> 16 & 0x7fffu, b.z >> 16 & 0x7fffu);
  return uvec3(lowX | lowY << 16, lowZ | highX << 16, highY | highZ << 16);
}
// An empty box. No ray enters it, and a union with it does not become larger.
const uint emptyBoxX = 0x7fff7fffu, emptyBoxY = 0x00007fffu, emptyBoxZ = 0u;

// A ray in grid coordinates. The ray crosses plane q of the grid at the distance q a + c (m). The flags tell along
// which axes the ray goes down.
struct RayPlanes {
  vec3 a;
  vec3 c;
  bool backX;
  bool backY;
  bool backZ;
};

FUNCTION float heldAway(float x) {
  return abs(x) < 1e-9f ? (x < 0.0f ? -1e-9f : 1e-9f) : x;
}
FUNCTION RayPlanes rayPlanes(RayGrid grid, vec3 origin, vec3 direction) {
  vec3 per = vec3(exactReciprocal(heldAway(direction.x)), exactReciprocal(heldAway(direction.y)),
                  exactReciprocal(heldAway(direction.z)));
  precise vec3 a = grid.cell * per;
  precise vec3 c = (grid.low - origin) * per;
  RayPlanes planes;
  planes.a = a;
  planes.c = c;
  planes.backX = per.x < 0.0f;
  planes.backY = per.y < 0.0f;
  planes.backZ = per.z < 0.0f;
  return planes;
}

// greatestFromZero() returns the max of the components and 0. The second function returns the min of the components, if
// none is negative. Both compare bits as integers, because the bits of positive floats have the order of their values,
// integer comparisons are faster on some drivers, and NaN cannot occur.
FUNCTION float greatestFromZero(vec3 v) {
  return intBitsToFloat(max(max(floatBitsToInt(v.x), floatBitsToInt(v.y)), max(floatBitsToInt(v.z), 0)));
}
FUNCTION float minAbove(vec3 v) {
  return intBitsToFloat(min(min(floatBitsToInt(v.x), floatBitsToInt(v.y)), floatBitsToInt(v.z)));
}
// Returns true if from <= to, where from >= 0; `to` may be negative.
FUNCTION bool isWithin(float from, float to) {
  return floatBitsToInt(from) <= floatBitsToInt(to);
}

// Returns the distances (m) at which the ray enters and leaves a box. If the ray misses the box, the second distance is
// smaller than the first or negative.
FUNCTION vec2 spanIn(RayPlanes planes, uint x, uint y, uint z) {
  int lowX = int(x & 0x7fffu), lowY = int(x >> 16 & 0x7fffu), lowZ = int(y & 0x7fffu);
  int highX = int(y >> 16 & 0x7fffu), highY = int(z & 0x7fffu), highZ = int(z >> 16 & 0x7fffu);
  vec3 near = vec3(float(planes.backX ? highX : lowX), float(planes.backY ? highY : lowY), float(planes.backZ ? highZ : lowZ));
  vec3 far = vec3(float(planes.backX ? lowX : highX), float(planes.backY ? lowY : highY), float(planes.backZ ? lowZ : highZ));
  precise vec3 enters = near * planes.a + planes.c;
  precise vec3 leaves = far * planes.a + planes.c;
  return vec2(greatestFromZero(enters), minAbove(leaves));
}
#endif

// Multigrid step to a finer level: adds the coarser level's correction, then applies a red-black sweep. One invocation
// per block of 2x2 cells, as in descend.comp.
#include "fluid/solver/levels.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { vec4 raisedOut[]; };

#if IN_THE_OPEN != 0
// Five consecutive coarse cells, from two cells before the coarse cell of this block to two cells after it.
struct Five {
  float a, b, c, d, e;
};

Five fiveOf(bool odd, vec2 before, vec2 here, vec2 after) {
  Five f;
  f.a = odd ? before.y : before.x;
  f.b = odd ? here.x : before.y;
  f.c = odd ? here.y : here.x;
  f.d = odd ? after.x : here.y;
  f.e = odd ? after.y : after.x;
  return f;
}

Five eitherOf(bool odd, Five lower, Five upper) {
  Five f;
  f.a = odd ? lower.a : upper.a;
  f.b = odd ? lower.b : upper.b;
  f.c = odd ? lower.c : upper.c;
  f.d = odd ? lower.d : upper.d;
  f.e = odd ? lower.e : upper.e;
  return f;
}

float openAt(float way, float here, float across, float down, float corner) {
  return raised(way, prolonged(here, across, down, corner));
}

vec4 sweptOpen(ivec2 block, int element, int row) {
  int coarseRow = (level.cells.x + 1) / 2 / 2 + 1;
  int coarse = level.coarseUp + (block.y >> 1) * coarseRow + (block.x >> 1);
  bool odd = (block.x & 1) == 1, oddRow = (block.y & 1) == 1;
  vec4 p = LOAD_INPUT(raisedPool, coarse - coarseRow - 1), q = LOAD_INPUT(raisedPool, coarse - coarseRow);
  vec4 r = LOAD_INPUT(raisedPool, coarse - coarseRow + 1);
  Five c0 = fiveOf(odd, p.xy, q.xy, r.xy), c1 = fiveOf(odd, p.zw, q.zw, r.zw);
  p = LOAD_INPUT(raisedPool, coarse - 1);
  q = LOAD_INPUT(raisedPool, coarse);
  r = LOAD_INPUT(raisedPool, coarse + 1);
  Five c2 = fiveOf(odd, p.xy, q.xy, r.xy), c3 = fiveOf(odd, p.zw, q.zw, r.zw);
  p = LOAD_INPUT(raisedPool, coarse + coarseRow - 1);
  q = LOAD_INPUT(raisedPool, coarse + coarseRow);
  r = LOAD_INPUT(raisedPool, coarse + coarseRow + 1);
  Five c4 = fiveOf(odd, p.xy, q.xy, r.xy), c5 = fiveOf(odd, p.zw, q.zw, r.zw);
  Five n = eitherOf(oddRow, c1, c0), m = eitherOf(oddRow, c2, c1), o = eitherOf(oddRow, c3, c2);
  Five s = eitherOf(oddRow, c4, c3), t = eitherOf(oddRow, c5, c4);
  vec4 here = LOAD_INPUT(raisedPool, level.way + element);
  vec4 before = LOAD_INPUT(raisedPool, level.way + element - 1), after = LOAD_INPUT(raisedPool, level.way + element + 1);
  vec4 above = LOAD_INPUT(raisedPool, level.way + element - row), below = LOAD_INPUT(raisedPool, level.way + element + row);
  vec4 aboveAfter = LOAD_INPUT(raisedPool, level.way + element - row + 1);
  vec4 belowBefore = LOAD_INPUT(raisedPool, level.way + element + row - 1);
  float b10 = openAt(here.y, o.c, o.d, m.c, m.d), b01 = openAt(here.z, o.c, o.b, s.c, s.b);
  float bm0 = openAt(before.y, o.b, o.c, m.b, m.c), bn1 = openAt(before.z, o.b, o.a, s.b, s.a);
  float b0m = openAt(above.z, m.c, m.b, o.c, o.b), b1n = openAt(above.y, m.c, m.d, n.c, n.d);
  float b30 = openAt(after.y, o.d, o.e, m.d, m.e), b21 = openAt(after.z, o.d, o.c, s.d, s.c);
  float b12 = openAt(below.y, s.c, s.d, o.c, o.d), b03 = openAt(below.z, s.c, s.b, t.c, t.b);
  float b2m = openAt(aboveAfter.z, m.d, m.c, o.d, o.c), bm2 = openAt(belowBefore.y, s.b, s.c, o.b, o.c);
  vec4 rhs = LOAD_INPUT(pool, level.rhs + element);
  float r00 = relaxedOpen(rhs.x, aroundOpen(bm0, b10, b0m, b01));
  float r11 = relaxedOpen(rhs.w, aroundOpen(b01, b21, b10, b12));
  float r20 = relaxedOpen(LOAD_INPUT(pool, level.rhs + element + 1).x, aroundOpen(b10, b30, b2m, b21));
  float r1m = relaxedOpen(LOAD_INPUT(pool, level.rhs + element - row).w, aroundOpen(b0m, b2m, b1n, b10));
  float rm1 = relaxedOpen(LOAD_INPUT(pool, level.rhs + element - 1).w, aroundOpen(bn1, b01, bm0, bm2));
  float r02 = relaxedOpen(LOAD_INPUT(pool, level.rhs + element + row).x, aroundOpen(bm2, b12, b01, b03));
  return vec4(r00, relaxedOpen(rhs.y, aroundOpen(r00, r20, r1m, r11)), relaxedOpen(rhs.z, aroundOpen(rm1, r11, r00, r02)), r11);
}
#endif

#ifdef TILE_A_GROUP
#include "fluid/solver/block.glsl"
const int windowStride = 14;
shared float values[14 * 14];
#include "fluid/solver/window.glsl"

// Returns a coarse cell's correction, like the function of the same name below.
float coarseAt(ivec2 c) {
  ivec2 count = level.cells / 2 + (level.cells & 1);
#if LEFT == 4
  c.x = c.x < 0 ? c.x + count.x : c.x >= count.x ? c.x - count.x : c.x;
#endif
#if TOP == 4
  c.y = c.y < 0 ? c.y + count.y : c.y >= count.y ? c.y - count.y : c.y;
#endif
  if (walledOff(c, count)) return noCell;
  ivec2 near = clamp(c, ivec2(0), count - 1);
  float value = raisedPool[level.coarseUp + (near.y >> 1) * (count.x / 2 + 1) + (near.x >> 1)][2 * (near.y & 1) + (near.x & 1)];
  return value < noCell && near != c ? -value : value;
}

vec3 coarseRow(ivec2 c) {
  return vec3(coarseAt(c - ivec2(1, 0)), coarseAt(c), coarseAt(c + ivec2(1, 0)));
}

void sweepTile(ivec2 tile) {
  ivec2 lane = ivec2(gl_LocalInvocationID.xy);
  ivec2 block = 4 * tile + lane - 1;
  bool used = lane.x < 6 && lane.y < 6;
  ivec2 place = blockWithin(block, level.cells);
  int at = used ? cornerOf(lane) : cornerOf(ivec2(0)), element = place.y * blocksOf(level.cells).x + place.x;
  Block b;
  vec4 here = vec4(0.0);
  if (used) {
    b = blockAt(place, level.cells, level.weights);
    if (b.inside != 0) {
      b.rhs = LOAD_INPUT(pool, level.rhs + element);
      here = LOAD_INPUT(raisedPool, level.way + element);
      raiseBlock(b, here, coarseRow(place - ivec2(0, 1)), coarseRow(place), coarseRow(place + ivec2(0, 1)));
    }
    putReds(at, here);
    putBlacks(at, here);
  }
  barrier();
  if (used) {
    sweepReds(b, here, besideReds(at));
    putReds(at, here);
  }
  barrier();
  bool own = lane.x > 0 && lane.y > 0 && lane.x < 5 && lane.y < 5;
  if (!own || place != block || b.inside == 0) return;
  sweepBlacks(b, here, besideBlacks(at));
  raisedOut[level.up + element] = here;
}
#elif IN_THE_OPEN != 1
// Returns a coarse cell's correction. Beyond walls it is noCell; beyond open sides it is the negated correction of the
// border cell, so that the correction on the side is 0.
float coarseAt(ivec2 c) {
  ivec2 count = (level.cells + 1) / 2;
#if LEFT == 4
  c.x = c.x < 0 ? c.x + count.x : c.x >= count.x ? c.x - count.x : c.x;
#endif
#if TOP == 4
  c.y = c.y < 0 ? c.y + count.y : c.y >= count.y ? c.y - count.y : c.y;
#endif
  bool wall = (c.x < 0 && LEFT != openSide) || (c.x >= count.x && RIGHT != openSide) || (c.y < 0 && TOP != openSide) ||
              (c.y >= count.y && BOTTOM != openSide);
  if (wall) return noCell;
  ivec2 near = clamp(c, ivec2(0), count - 1);
  float value = cellOf(LOAD_INPUT(raisedPool, level.coarseUp + (near.y >> 1) * (count.x / 2 + 1) + (near.x >> 1)), near);
  return value < noCell && near != c ? -value : value;
}

float raisedAt(ivec2 place) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  ivec2 here = c >> 1, to = here + 2 * (c & 1) - 1;
  float more = prolonged(coarseAt(here), coarseAt(ivec2(to.x, here.y)), coarseAt(ivec2(here.x, to.y)), coarseAt(to));
  return raised(inRaised(level.way, c), more);
}

// Returns the relaxed value of a cell of either colour.
float sweptAt(ivec2 place, float left, float right, float top, float bottom) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  vec4 w = weightsOf(c);
  return relaxed(inPool(level.rhs, c), neighbours(w, left, right, top, bottom), diagonal(w));
}

// Returns the value of a red cell after the red half of the sweep. On a torus with an odd number of cells, the cell at
// the seam can be black; its value is then returned unchanged.
float redAt(ivec2 place, float left, float right, float top, float bottom) {
  return isRed(within(place)) ? sweptAt(place, left, right, top, bottom) : raisedAt(place);
}

vec4 sweptOther(ivec2 block, int element, int row) {
  ivec2 o = 2 * block;
  float b10 = raisedAt(o + ivec2(1, 0)), b01 = raisedAt(o + ivec2(0, 1));
  float bm0 = raisedAt(o + ivec2(-1, 0)), b0m = raisedAt(o + ivec2(0, -1));
  float b30 = raisedAt(o + ivec2(3, 0)), b2m = raisedAt(o + ivec2(2, -1)), b21 = raisedAt(o + ivec2(2, 1));
  float b1n = raisedAt(o + ivec2(1, -2)), b12 = raisedAt(o + ivec2(1, 2));
  float bn1 = raisedAt(o + ivec2(-2, 1)), bm2 = raisedAt(o + ivec2(-1, 2)), b03 = raisedAt(o + ivec2(0, 3));
  float r00 = redAt(o, bm0, b10, b0m, b01);
  float r11 = redAt(o + ivec2(1, 1), b01, b21, b10, b12);
  float r20 = redAt(o + ivec2(2, 0), b10, b30, b2m, b21);
  float r1m = redAt(o + ivec2(1, -1), b0m, b2m, b1n, b10);
  float rm1 = redAt(o + ivec2(-1, 1), bn1, b01, bm0, bm2);
  float r02 = redAt(o + ivec2(0, 2), bm2, b12, b01, b03);
  return vec4(r00, sweptAt(o + ivec2(1, 0), r00, r20, r1m, r11), sweptAt(o + ivec2(0, 1), rm1, r11, r00, r02), r11);
}
#endif

void main() {
#ifdef TILE_A_GROUP
  if (!inTheOpen()) {
    ivec2 tile = tileHere();
    if (tile.x < 0xffff) sweepTile(tile);
    return;
  }
#endif
  ivec2 block = blockHere();
  ivec2 blocks = blocksOf(level.cells);
  if (block.x >= blocks.x || block.y >= blocks.y) return;
  int element = block.y * blocks.x + block.x;
#if IN_THE_OPEN != 0
  if (inTheOpen()) raisedOut[level.up + element] = sweptOpen(block, element, blocks.x);
#endif
#if IN_THE_OPEN != 1 && !defined TILE_A_GROUP
  if (!inTheOpen()) raisedOut[level.up + element] = sweptOther(block, element, blocks.x);
#endif
}

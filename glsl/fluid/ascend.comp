// Adds the coarser level's correction, then a red-black sweep. As descend.comp, by blocks of 2x2 cells.
#include "fluid/levels.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { vec4 raisedOut[]; };
uniform int coarseStart;  // of the coarser level, in raisedPool

// A coarse cell's correction; noCell beyond walls, and beyond open sides what makes it 0 there.
float coarseAt(ivec2 c) {
  ivec2 count = (cells + 1) / 2;
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
  float value = cellOf(LOAD_INPUT(raisedPool, coarseStart + (near.y >> 1) * (count.x / 2 + 1) + (near.x >> 1)), near);
  return value < noCell && near != c ? -value : value;
}

float raisedAt(ivec2 place) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  ivec2 here = c >> 1, to = here + 2 * (c & 1) - 1;
  float more = prolonged(coarseAt(here), coarseAt(ivec2(to.x, here.y)), coarseAt(ivec2(here.x, to.y)), coarseAt(to));
  return raised(inRaised(wayStart, c), more);
}

// Of a cell of either colour, given its neighbours.
float sweptAt(ivec2 place, float left, float right, float top, float bottom) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  vec4 w = weightsOf(c);
  return relaxed(inPool(rhsStart, c), neighbours(w, left, right, top, bottom), diagonal(w));
}

// A red cell after its half of the sweep; where an odd torus closes it may be a black one, which is not swept yet.
float redAt(ivec2 place, float left, float right, float top, float bottom) {
  return isRed(within(place)) ? sweptAt(place, left, right, top, bottom) : raisedAt(place);
}

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 blocks = blocksOf(cells);
  if (block.x >= blocks.x || block.y >= blocks.y) return;
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
  raisedOut[levelStart + block.y * blocks.x + block.x] =
      vec4(r00, sweptAt(o + ivec2(1, 0), r00, r20, r1m, r11), sweptAt(o + ivec2(0, 1), rm1, r11, r00, r02), r11);
}

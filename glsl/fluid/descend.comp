// From no correction: a red-black sweep, and what it leaves missing in the red cells for the coarser level (the black ones
// fulfil their equations). An invocation takes a block of 2x2 cells, and repeats what its sweep reads around.
#include "fluid/levels.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { float poolOut[]; };
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { vec4 raisedOut[]; };

float redAt(ivec2 place) {
  ivec2 c = within(place);
  if (!isInside(c) || !isRed(c)) return 0.0;
  return relaxed(inPool(rhsStart, c), 0.0, diagonal(weightsOf(c)));
}

// Of a black cell, given its neighbours; where an odd torus closes it may be a red one.
float blackAt(ivec2 place, float left, float right, float top, float bottom) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  vec4 w = weightsOf(c);
  float sum = neighbours(w, left, right, top, bottom);
  return relaxed(inPool(rhsStart, c), isRed(c) ? 0.0 : sum, diagonal(w));
}

float leftOver(ivec2 c, float value, float left, float right, float top, float bottom) {
  if (!isInside(c)) return 0.0;
  return residual(inPool(rhsStart, c), weightsOf(c), value, left, right, top, bottom);
}

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 blocks = blocksOf(cells);
  if (block.x >= blocks.x || block.y >= blocks.y) return;
  ivec2 o = 2 * block;
  // By their places from the block's first cell: m is -1, n is -2.
  float r00 = redAt(o), r11 = redAt(o + ivec2(1, 1));
  float rn0 = redAt(o + ivec2(-2, 0)), r20 = redAt(o + ivec2(2, 0)), r31 = redAt(o + ivec2(3, 1));
  float r0n = redAt(o + ivec2(0, -2)), r02 = redAt(o + ivec2(0, 2)), r13 = redAt(o + ivec2(1, 3));
  float rmm = redAt(o + ivec2(-1, -1)), rm1 = redAt(o + ivec2(-1, 1));
  float r1m = redAt(o + ivec2(1, -1)), r22 = redAt(o + ivec2(2, 2));
  float b10 = blackAt(o + ivec2(1, 0), r00, r20, r1m, r11);
  float b01 = blackAt(o + ivec2(0, 1), rm1, r11, r00, r02);
  float bm0 = blackAt(o + ivec2(-1, 0), rn0, r00, rmm, rm1);
  float b0m = blackAt(o + ivec2(0, -1), rmm, r1m, r0n, r00);
  float b21 = blackAt(o + ivec2(2, 1), r11, r31, r20, r22);
  float b12 = blackAt(o + ivec2(1, 2), r02, r22, r11, r13);
  raisedOut[wayStart + block.y * blocks.x + block.x] = vec4(r00, b10, b01, r11);
  ivec2 coarse = (cells + 1) / 2;
  if (block.x >= coarse.x || block.y >= coarse.y) return;
  float left = restricted(leftOver(o, r00, bm0, b10, b0m, b01), leftOver(o + ivec2(1, 1), r11, b01, b21, b10, b12));
  poolOut[4 * (nextRhsStart + (block.y >> 1) * (coarse.x / 2 + 1) + (block.x >> 1)) + 2 * (block.y & 1) + (block.x & 1)] = left;
}

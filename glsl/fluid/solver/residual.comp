// Adds the finest level's correction to the sum of corrections and computes the remaining right-hand side.
#include "fluid/solver/levels.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { vec4 poolOut[]; };

#if IN_THE_OPEN != 0
vec4 leftOpen(vec4 rhs, vec4 here, ivec2 block, int element, int row) {
  vec4 before = LOAD_INPUT(raisedPool, element - 1), after = LOAD_INPUT(raisedPool, element + 1);
  vec4 above = LOAD_INPUT(raisedPool, element - row), below = LOAD_INPUT(raisedPool, element + row);
  return vec4(residualOpen(rhs.x, here.x, before.y, here.y, above.z, here.z),
              residualOpen(rhs.y, here.y, here.x, after.x, above.w, here.w),
              residualOpen(rhs.z, here.z, before.w, here.w, here.x, below.x),
              residualOpen(rhs.w, here.w, here.z, after.z, here.y, below.y));
}
#endif

#if IN_THE_OPEN != 1
float valueAt(ivec2 place) {
  return inRaised(0, within(place));
}

float leftOver(ivec2 c, float rhs) {
  if (c.x >= level.cells.x || c.y >= level.cells.y) return 0.0;
  return residual(rhs, weightsOf(c), inRaised(0, c), valueAt(c - ivec2(1, 0)), valueAt(c + ivec2(1, 0)),
                  valueAt(c - ivec2(0, 1)), valueAt(c + ivec2(0, 1)));
}
#endif

#ifdef TILE_A_GROUP
// Processes one cell and returns its remaining right-hand side.
float takenInCell(ivec2 c, ivec2 blocks) {
  int element = blockOf(c), k = 2 * (c.y & 1) + (c.x & 1), ofLost = blocks.x * blocks.y + element;
  float left = leftOver(c, pool[level.rhs + element][k]);
  float more = raisedPool[element][k];
  more = more >= noCell ? 0.0 : more;
  float sum = pool[element][k];
  if (control.begun > 1u) poolOut[ofLost][k] = added(pool[ofLost][k], lostInSum(sum, more));
  poolOut[element][k] = added(sum, more);
  poolOut[level.rhs + element][k] = left;
  return left;
}
#elif IN_THE_OPEN != 1
vec4 leftOther(vec4 rhs, ivec2 block) {
  ivec2 o = 2 * block;
  return vec4(leftOver(o, rhs.x), leftOver(o + ivec2(1, 0), rhs.y), leftOver(o + ivec2(0, 1), rhs.z),
              leftOver(o + ivec2(1, 1), rhs.w));
}
#endif

#if IN_THE_OPEN != 0 || !defined TILE_A_GROUP
vec4 addedTo(vec4 a, vec4 b) {
  return vec4(added(a.x, b.x), added(a.y, b.y), added(a.z, b.z), added(a.w, b.w));
}

vec4 lostInSums(vec4 a, vec4 b) {
  return vec4(lostInSum(a.x, b.x), lostInSum(a.y, b.y), lostInSum(a.z, b.z), lostInSum(a.w, b.w));
}

// Processes a block and returns its remaining right-hand side.
vec4 takenIn(ivec2 block, ivec2 blocks) {
  int element = block.y * blocks.x + block.x, ofLost = blocks.x * blocks.y + element;
  vec4 rhs = LOAD_INPUT(pool, level.rhs + element);
  vec4 more = LOAD_INPUT(raisedPool, element);
#if IN_THE_OPEN == 1 || defined TILE_A_GROUP
  vec4 left = leftOpen(rhs, more, block, element, blocks.x);
#elif IN_THE_OPEN == 0
  vec4 left = leftOther(rhs, block);
#else
  vec4 left = inTheOpen() ? leftOpen(rhs, more, block, element, blocks.x) : leftOther(rhs, block);
#endif
  more = vec4(more.x >= noCell ? 0.0 : more.x, more.y >= noCell ? 0.0 : more.y, more.z >= noCell ? 0.0 : more.z,
              more.w >= noCell ? 0.0 : more.w);
  // In the first cycle, the sum equals the correction and has no rounding error.
  vec4 sum = vec4(0.0);
  if (control.begun > 1u) {
    sum = LOAD_INPUT(pool, element);
    vec4 lost = vec4(0.0);
    if (control.begun > 2u) lost = LOAD_INPUT(pool, ofLost);
    poolOut[ofLost] = addedTo(lost, lostInSums(sum, more));
  }
  poolOut[element] = addedTo(sum, more);
  poolOut[level.rhs + element] = left;
  return left;
}
#endif

float missingHere() {
  ivec2 blocks = blocksOf(level.cells);
#ifdef TILE_A_GROUP
  if (!inTheOpen()) {
    ivec2 c = 8 * tileHere() + ivec2(gl_LocalInvocationID.xy);
    return c.x < level.cells.x && c.y < level.cells.y ? abs(takenInCell(c, blocks)) : 0.0;
  }
#endif
#if IN_THE_OPEN != 0 || !defined TILE_A_GROUP
  ivec2 block = blockHere();
  if (block.x >= blocks.x || block.y >= blocks.y) return 0.0;
  vec4 sizes = abs(takenIn(block, blocks));
  return max(max(sizes.x, sizes.y), max(sizes.z, sizes.w));
#else
  return 0.0;
#endif
}

void main() {
  noteMissing(missingHere());
}

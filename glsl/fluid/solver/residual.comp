// Adds the finest level's correction to the sum, and says what is still missing.
#include "fluid/solver/levels.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { vec4 poolOut[]; };

#if IN_THE_OPEN == 1
vec4 leftOf(vec4 rhs, vec4 here, ivec2 block, int element, int row) {
  vec4 before = LOAD_INPUT(raisedPool, element - 1), after = LOAD_INPUT(raisedPool, element + 1);
  vec4 above = LOAD_INPUT(raisedPool, element - row), below = LOAD_INPUT(raisedPool, element + row);
  return vec4(residualOpen(rhs.x, here.x, before.y, here.y, above.z, here.z),
              residualOpen(rhs.y, here.y, here.x, after.x, above.w, here.w),
              residualOpen(rhs.z, here.z, before.w, here.w, here.x, below.x),
              residualOpen(rhs.w, here.w, here.z, after.z, here.y, below.y));
}

#else
float valueAt(ivec2 place) {
  return inRaised(0, within(place));
}

float leftOver(ivec2 c, float rhs) {
  if (c.x >= level.cells.x || c.y >= level.cells.y) return 0.0;
  return residual(rhs, weightsOf(c), inRaised(0, c), valueAt(c - ivec2(1, 0)), valueAt(c + ivec2(1, 0)),
                  valueAt(c - ivec2(0, 1)), valueAt(c + ivec2(0, 1)));
}

vec4 leftOf(vec4 rhs, vec4 here, ivec2 block, int element, int row) {
  ivec2 o = 2 * block;
  return vec4(leftOver(o, rhs.x), leftOver(o + ivec2(1, 0), rhs.y), leftOver(o + ivec2(0, 1), rhs.z),
              leftOver(o + ivec2(1, 1), rhs.w));
}
#endif

vec4 addedTo(vec4 a, vec4 b) {
  return vec4(added(a.x, b.x), added(a.y, b.y), added(a.z, b.z), added(a.w, b.w));
}

vec4 lostInSums(vec4 a, vec4 b) {
  return vec4(lostInSum(a.x, b.x), lostInSum(a.y, b.y), lostInSum(a.z, b.z), lostInSum(a.w, b.w));
}

// What is still missing of a block.
vec4 takenIn(ivec2 block, ivec2 blocks) {
  int element = block.y * blocks.x + block.x, ofLost = blocks.x * blocks.y + element;
  vec4 rhs = LOAD_INPUT(pool, level.rhs + element);
  vec4 more = LOAD_INPUT(raisedPool, element);
  vec4 left = leftOf(rhs, more, block, element, blocks.x);
  more = vec4(more.x >= noCell ? 0.0 : more.x, more.y >= noCell ? 0.0 : more.y, more.z >= noCell ? 0.0 : more.z,
              more.w >= noCell ? 0.0 : more.w);
  vec4 sum = LOAD_INPUT(pool, element), lost = LOAD_INPUT(pool, ofLost);
  poolOut[ofLost] = addedTo(lost, lostInSums(sum, more));
  poolOut[element] = addedTo(sum, more);
  poolOut[level.rhs + element] = left;
  return left;
}

void main() {
  ivec2 block = blockHere();
  ivec2 blocks = blocksOf(level.cells);
  vec4 left = vec4(0.0);
  if (block.x < blocks.x && block.y < blocks.y) left = takenIn(block, blocks);
  vec4 sizes = abs(left);
  noteMost(max(max(sizes.x, sizes.y), max(sizes.z, sizes.w)), 0.0, 0.0);
}

// Adds the finest level's correction to the sum, and says what is still missing.
#include "fluid/levels.glsl"
#include "fluid/solve_control.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { vec4 poolOut[]; };

float valueAt(ivec2 place) {
  return inRaised(0, within(place));
}

float leftOver(ivec2 c, float rhs) {
  if (c.x >= cells.x || c.y >= cells.y) return 0.0;
  return residual(rhs, weightsOf(c), inRaised(0, c), valueAt(c - ivec2(1, 0)), valueAt(c + ivec2(1, 0)),
                  valueAt(c - ivec2(0, 1)), valueAt(c + ivec2(0, 1)));
}

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 blocks = blocksOf(cells);
  if (block.x >= blocks.x || block.y >= blocks.y) return;
  ivec2 o = 2 * block;
  int element = block.y * blocks.x + block.x;
  vec4 rhs = LOAD_INPUT(pool, rhsStart + element);
  vec4 more = LOAD_INPUT(raisedPool, element);
  vec4 left = vec4(leftOver(o, rhs.x), leftOver(o + ivec2(1, 0), rhs.y), leftOver(o + ivec2(0, 1), rhs.z),
                   leftOver(o + ivec2(1, 1), rhs.w));
  more = vec4(more.x >= noCell ? 0.0 : more.x, more.y >= noCell ? 0.0 : more.y, more.z >= noCell ? 0.0 : more.z,
              more.w >= noCell ? 0.0 : more.w);
  vec4 sum = LOAD_INPUT(pool, element), lost = LOAD_INPUT(pool, blocks.x * blocks.y + element);
  poolOut[blocks.x * blocks.y + element] =
      vec4(added(lost.x, lostInSum(sum.x, more.x)), added(lost.y, lostInSum(sum.y, more.y)),
           added(lost.z, lostInSum(sum.z, more.z)), added(lost.w, lostInSum(sum.w, more.w)));
  poolOut[element] = vec4(added(sum.x, more.x), added(sum.y, more.y), added(sum.z, more.z), added(sum.w, more.w));
  poolOut[rhsStart + element] = left;
  vec4 sizes = abs(left);
  noteMost(max(max(sizes.x, sizes.y), max(sizes.z, sizes.w)), 0.0);
}

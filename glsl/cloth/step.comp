// Applies forces with semi-implicit Euler. One invocation per particle. Reads the positions of the last substep and
// writes the next positions to another array, so the order of workgroups does not matter.
#include "cloth/kernel.glsl"
#ifdef TEXEL_PATH
layout(local_size_x = 8, local_size_y = 8) in;
#else
layout(local_size_x = 32, local_size_y = 8) in;
#endif
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)

vec4 loadPosition(int i) {
  return LOAD_INPUT(positions, i);
}
#include "cloth/model.glsl"

void main() {
  // Every second substep processes the rows in reverse order, so that it starts with rows that are still in the GPU's
  // cache.
  uvec2 group = gl_WorkGroupID.xy;
  if ((stepData.substep & 1) == 1) group.y = gl_NumWorkGroups.y - 1u - group.y;
  ivec2 at = ivec2(group * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  int i = at.y * size.x + at.x;
  vec4 here = loadPosition(i);
  vec4 velocity = LOAD_ONCE(velocities, i);
  Motion m = advance(at, here, velocity, vec3(0.0f), SPRINGS == 1, AIR == 1, FABRIC == 1, CONTACT == 1, HEIGHTS == 1, WALLS == 1);
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
}

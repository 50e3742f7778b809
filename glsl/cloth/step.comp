// Forces and semi-implicit Euler in one pass: reads every position of the last substep, writes the next
// ones elsewhere, so no order of work groups changes the result.
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
  // Every other substep from the last row back, so that it begins with what the one before has left in the card's cache.
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

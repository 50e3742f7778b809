// Corrects the velocities after contact between cloths has pushed particles, then applies contact with colliders. One
// invocation per particle.
#include "cloth/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(leftBinding, LeftBlock, left)

vec4 loadPosition(int i) {
  return LOAD_INPUT(positions, i);
}
#include "cloth/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y) return;
  vec4 here = LOAD_ONCE(nextPositions, i), velocity = LOAD_ONCE(velocities, i);
  Motion m = settledAgain(loadPosition(i), LOAD_INPUT(left, i), here, velocity.xyz, HEIGHTS == 1, WALLS == 1);
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
}

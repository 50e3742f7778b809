// After the constraints: v = (x - x_before) / dt, then what the vertices meet.
#include "cloth/mesh/kernel.glsl"
#include "common/status.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
#include "cloth/motion.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 here = LOAD_ONCE(nextPositions, i);
  vec4 velocity = LOAD_ONCE(velocities, i);
  Motion m = settled(LOAD_INPUT(positions, i), here, HEIGHTS == 1, WALLS == 1);
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
}

// Computes velocities after the constraints, then applies contact. If AGAIN is defined, processes only the vertices
// that contact between cloths has pushed since. One invocation per vertex.
#include "garment/kernel.glsl"
#include "common/status.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
#if AGAIN
INPUT_ARRAY(leftBinding, LeftBlock, left)
#elif !KEEPS
STATE_ARRAY(settledTrendsBinding, TrendBlock, trends)
#endif
#include "cloth/motion.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 here = LOAD_ONCE(nextPositions, i);
  vec4 velocity = LOAD_ONCE(velocities, i);
#if AGAIN
  Motion m = settledAgain(LOAD_INPUT(positions, i), LOAD_INPUT(left, i), here, velocity.xyz, HEIGHTS == 1, WALLS == 1);
#elif KEEPS
  Motion m = forced(LOAD_INPUT(positions, i), here, velocity.xyz, HEIGHTS == 1, WALLS == 1);
#else
  vec4 trend = LOAD_ONCE(trends, i);
  Settled s = settled(LOAD_INPUT(positions, i), here, velocity.xyz, trend.xyz, HEIGHTS == 1, WALLS == 1);
  Motion m = s.motion;
  STORE_STATE(trends, i, vec4(s.trend, trend.w));
#endif
  if (isLost(m)) noteLost(uint(stepData.substep), uint(i));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
}

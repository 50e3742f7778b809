// Moves particles out of their colliders again after contact with cloth has moved them. One invocation per particle.
#define SETTLES
#include "particles/kernel.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.count) return;
  vec4 from = LOAD_INPUT(starts, i);
  ParticleMotion m = particleMotion(LOAD_ONCE(positions, i), LOAD_ONCE(velocities, i));
  if (from.w == 0.0f) return;  // Contact with cloth does not move new particles.
  if (SOLIDS == 1) m = outOfSolids(m, from.xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  if (WALLS == 1) m = besideWalls(m, from.xyz);
  STORE_STATE(positions, i, m.position);
  STORE_STATE(velocities, i, m.velocity);
  if (isLost(m.position, m.velocity)) noteLost(uint(stepData.substep), uint(i));
}

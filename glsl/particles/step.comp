// Computes a whole substep (kick, drift, kick) of particles without mutual gravity. One invocation per particle.
#include "particles/kernel.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.count) return;
  vec4 from = LOAD_STATE(positions, i);
  ParticleMotion m = moved(i, from, LOAD_STATE(velocities, i), LOAD_STATE(accelerations, i).xyz);
#ifdef ROLLS
  m = turning(m, LOAD_ONCE(spins, i));
#endif
  if (SOLIDS == 1) m = outOfSolids(m, from.xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  if (WALLS == 1) m = besideWalls(m, from.xyz);
  vec3 acceleration = fieldAcceleration(stepData.fields, m.position.xyz, ATTRACTOR == 1, TURBULENCE == 1);
  vec4 velocity = kicked(m.velocity, acceleration, stepData.pace);
  STORE_STATE(positions, i, m.position);
#ifdef ROLLS
  STORE_STATE(spins, i, spinOf(m));
#endif
  STORE_STATE(velocities, i, velocity);
  STORE_STATE(accelerations, i, vec4(acceleration, 0.0f));
  if (isLost(m.position, velocity)) noteLost(uint(stepData.substep), uint(i));
}

// Applies the first kick and the drift to all particles, ages them and removes dead ones. One invocation per particle.
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
  STORE_STATE(positions, i, m.position);
#ifdef ROLLS
  STORE_STATE(spins, i, spinOf(m));
#endif
  STORE_STATE(velocities, i, m.velocity);
}

// First kick and drift of every particle; deaths.
#include "particles/kernel.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.count) return;
  ParticleMotion m =
      moved(i, LOAD_STATE(positions, i), LOAD_STATE(velocities, i), LOAD_STATE(accelerations, i).xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  STORE_STATE(positions, i, m.position);
  STORE_STATE(velocities, i, m.velocity);
}

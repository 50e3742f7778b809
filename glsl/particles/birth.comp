// Creates the new particles of a substep and moves each from its birth to the end of the substep. Runs after the drift
// of the other particles. If ATTRACTS is defined, kick.comp applies the second kick, because the kick needs the gravity
// of the other particles. One invocation per new particle.
#include "particles/kernel.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  int e = 0;
  while (e < stepData.emitterCount && k >= stepData.emitters[e].newborns) {
    k -= stepData.emitters[e].newborns;
    ++e;
  }
  if (e == stepData.emitterCount) return;
  int i = newbornSlot(e, k);
  ParticleMotion m = newbornMoved(e, k, ATTRACTOR == 1, TURBULENCE == 1);
  if (SOLIDS == 1) m = outOfSolids(m, m.position.xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  if (WALLS == 1) m = besideWalls(m, m.position.xyz);
  STORE_STATE(positions, i, m.position);
#ifdef ATTRACTS
  STORE_STATE(velocities, i, m.velocity);
#else
  vec3 acceleration = fieldAcceleration(stepData.fields, m.position.xyz, ATTRACTOR == 1, TURBULENCE == 1);
  vec4 velocity = kicked(m.velocity, acceleration, paceOf(livedSeconds(e, k), stepData.constants.damping));
  STORE_STATE(velocities, i, velocity);
  STORE_STATE(accelerations, i, vec4(acceleration, 0.0f));
  if (isLost(m.position, velocity)) noteLost(uint(stepData.substep), uint(i));
#endif
}

// Adds the accelerations by fields to the gravity of the particles and applies the second kick. One invocation per
// particle.
#include "particles/kernel.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.count) return;
  ParticleMotion m = particleMotion(LOAD_STATE(positions, i), LOAD_STATE(velocities, i));
  vec3 pull = LOAD_STATE(accelerations, i).xyz;
  Pace pace = stepData.pace;
  ivec2 place = ringPlace(i);
  if (place.y >= 0) {
    pace = paceOf(livedSeconds(place.x, place.y), stepData.constants.damping);
    m = pulledSinceBirth(m, pull, pace);
    STORE_STATE(positions, i, m.position);
  }
  precise vec3 acceleration = pull + fieldAcceleration(stepData.fields, m.position.xyz, ATTRACTOR == 1, TURBULENCE == 1);
  vec4 velocity = kicked(m.velocity, acceleration, pace);
  STORE_STATE(accelerations, i, vec4(acceleration, 0.0f));
  STORE_STATE(velocities, i, velocity);
  if (isLost(m.position, velocity)) noteLost(uint(stepData.substep), uint(i));
}

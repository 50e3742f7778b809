// Adds the fields to the particles' own gravity and makes the second half kick.
#include "particles/bindings.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.counts.x) return;
  vec4 position = LOAD_STATE(positions, i);
  precise vec3 acceleration =
      LOAD_STATE(accelerations, i).xyz + fieldAcceleration(position.xyz, ATTRACTOR, TURBULENCE);
  vec4 velocity = kicked(LOAD_STATE(velocities, i), acceleration);
  STORE_STATE(accelerations, i, vec4(acceleration, 0.0f));
  STORE_STATE(velocities, i, velocity);
  if (isLost(position, velocity)) noteLost(uint(stepData.counts.y), uint(i));
}

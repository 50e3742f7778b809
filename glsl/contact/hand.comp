// Copies the positions after the impulses back to a simulation and updates the velocities of balls. One invocation per
// vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(partNextBinding, PartNextBlock, partNext)
STATE_ARRAY(partVelocitiesBinding, PartVelocityBlock, partVelocities)
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int v = first + i;
  vec4 wanted = pointAt(wantedSection, v);
  STORE_STATE(partNext, i, wanted);
  // Only live balls get a new velocity. A cloth derives its velocity from its new positions (settledAgain of
  // cloth/motion.glsl).
  if (!isBall(v) || pointAt(nowSection, v).w == 0.0f) return;
  vec4 velocity = LOAD_ONCE(partVelocities, i);
  vec3 speed = speedBy(velocity.xyz, pointAt(nextSection, v).xyz, wanted.xyz);
  STORE_STATE(partVelocities, i, vec4(speed, velocity.w));
}

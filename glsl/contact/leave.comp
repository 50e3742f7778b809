// Applies the limits of hold.comp and writes the final positions and velocities back to a simulation. One invocation
// per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(partNextBinding, PartNextBlock, partNext)
STATE_ARRAY(partVelocitiesBinding, PartVelocityBlock, partVelocities)
layout(std430, binding = talliesBinding) restrict buffer TallyBlock { ivec4 tallies[]; };
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int v = first + i;
  vec4 now = pointAt(nowSection, v), next = LOAD_ONCE(partNext, i), velocity = LOAD_ONCE(partVelocities, i);
  if (now.w == 0.0f) return;
  ivec4 lets = tallies[letSection * contactStep.vertices + v];
  int bits = control.stopped == 1u ? lets.w : min(min(lets.x, lets.y), lets.z);
  vec3 start = pointAt(nothingCarried() ? nowSection : startSection, v).xyz;
  vec3 end = heldAt(start, pointAt(wantedSection, v).xyz, intBitsToFloat(bits));
  vec3 speed = speedBy(velocity.xyz, next.xyz, end);
  STORE_STATE(partNext, i, vec4(end, next.w));
  STORE_STATE(partVelocities, i, vec4(speed, velocity.w));
}

// Writes the target positions of this substep into the velocities of pinned particles that follow a skinned body. The
// velocities are available for that purpose, because a pinned particle's velocity is zero after each substep. The
// kernels that predict motion read the targets from there (cloth/motion.glsl). One invocation per such particle.
#include "common/bindings.glsl"
#include "common/memory.glsl"
#include "cloth/bindings.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(waysBinding, WayBlock, ways)
uniform int count;
uniform float before;  // Weight of the position at the start of the frame
uniform float now;
#include "cloth/held.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  vec4 begin = LOAD_INPUT(ways, 2 * k), end = LOAD_INPUT(ways, 2 * k + 1);
  STORE_STATE(velocities, int(begin.w), vec4(heldBetween(begin.xyz, end.xyz, before, now), -1.0f));
}

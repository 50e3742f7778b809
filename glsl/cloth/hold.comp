// Leaves in the velocities of pinned particles that follow a skin where they go in this substep; the kernels that predict take
// it from there (cloth/motion.glsl), and velocities of what is pinned are zero after each substep.
#include "common/bindings.glsl"
#include "common/memory.glsl"
#include "cloth/bindings.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(waysBinding, WayBlock, ways)
uniform int count;
uniform float before;  // share of the frame's beginning
uniform float now;
#include "cloth/held.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  vec4 begin = LOAD_INPUT(ways, 2 * k), end = LOAD_INPUT(ways, 2 * k + 1);
  STORE_STATE(velocities, int(begin.w), vec4(heldBetween(begin.xyz, end.xyz, before, now), -1.0f));
}

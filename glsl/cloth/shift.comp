// Adds the position and velocity changes by thin colliders to the vertices of any cloth. One invocation per vertex.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "cloth/bindings.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(shiftsBinding, ShiftBlock, shifts)
uniform int vertices;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= vertices) return;
  vec4 here = LOAD_ONCE(nextPositions, i), velocity = LOAD_ONCE(velocities, i);
  precise vec3 moved = here.xyz + LOAD_INPUT(shifts, 2 * i).xyz;
  precise vec3 v = velocity.xyz + LOAD_INPUT(shifts, 2 * i + 1).xyz;
  STORE_STATE(nextPositions, i, vec4(moved, here.w));
  STORE_STATE(velocities, i, vec4(v, velocity.w));
}

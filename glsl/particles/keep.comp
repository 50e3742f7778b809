// Copies the positions at the start of a substep, for particles in contact with cloth. The remaining part of the
// substep changes the copy. One invocation per particle.
#include "common/memory.glsl"
#include "particles/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(startsBinding, StartBlock, starts)
STATE_ARRAY(positionsBinding, PositionBlock, positions)
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) STORE_STATE(positions, i, LOAD_INPUT(starts, i));
}

// Deformed positions from positions at rest, which are only read.
#include "mesh/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, RestBlock, rests)
INPUT_ARRAY(1, TrailBlock, trail)
STATE_ARRAY(2, PositionBlock, positions)

vec4 loadTrail(int i) {
  return LOAD_INPUT(trail, i);
}
#include "mesh/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= deformStep.counts.z) return;
  STORE_STATE(positions, i, vec4(displaced(LOAD_INPUT(rests, i).xyz), 1));
}

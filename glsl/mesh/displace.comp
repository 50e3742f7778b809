// Computes the deformed positions from the rest positions. One invocation per vertex.
#include "mesh/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(restPositionsBinding, RestBlock, restPositions)
INPUT_ARRAY(trailBinding, TrailBlock, trail)
STATE_ARRAY(positionsBinding, PositionBlock, positions)

vec4 loadTrail(int i) {
  return LOAD_INPUT(trail, i);
}
#include "mesh/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= deformStep.vertexCount) return;
  STORE_STATE(positions, i, vec4(displaced(LOAD_INPUT(restPositions, i).xyz), 1));
}

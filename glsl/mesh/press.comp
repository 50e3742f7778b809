// Presses what touches the surface into its trail, one cell an invocation.
#include "mesh/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
STATE_ARRAY(0, TrailBlock, trail)

vec4 loadTrail(int i) {
  return LOAD_STATE(trail, i);
}
#include "mesh/model.glsl"

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= deformStep.trailCells.x || cell.y >= deformStep.trailCells.y) return;
  int i = cell.y * deformStep.trailCells.x + cell.x;
  STORE_STATE(trail, i, trodden(cell, loadTrail(i)));
}

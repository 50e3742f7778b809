// Adds the prints of the pressers (spheres and capsules, such as feet) to the trail, a grid with the depths and rim
// heights of all prints so far. One invocation per cell.
#include "mesh/kernel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
STATE_ARRAY(trailBinding, TrailBlock, trail)

vec4 loadTrail(int i) {
  return LOAD_STATE(trail, i);
}
#include "mesh/model.glsl"

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= deformStep.trail.cells.x || cell.y >= deformStep.trail.cells.y) return;
  int i = cell.y * deformStep.trail.cells.x + cell.x;
  STORE_STATE(trail, i, trodden(cell, loadTrail(i)));
}

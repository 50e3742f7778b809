// Advances the heights by one frame: the current heights become those at the start of the frame, and the new heights
// become those at its end. One invocation per vertex.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "mesh/bindings.glsl"
#include "mesh/height_types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(heightsBinding, HeightBlock, heights)
uniform int count;
uniform float lift;  // Height of the mesh's origin, m
uniform int component;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 position = LOAD_INPUT(positions, i);
  precise float now = (component == 0 ? position.x : position.y) + lift;
  STORE_STATE(heights, i, vec4(LOAD_STATE(heights, i).y, now, 0.0f, 0.0f));
}

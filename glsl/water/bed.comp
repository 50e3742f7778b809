// Moves the bed to the heights of another object (WaterParameters::groundObject). One invocation per cell.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
#define HEIGHTS 1
#include "mesh/height_array.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
STATE_ARRAY(cellsBinding, CellBlock, cells)
uniform ivec2 size;
uniform bool fresh;
#include "water/model.glsl"
#include "water/bed.glsl"
uniform WaterGround waterGround;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  int i = at.y * size.x + at.x;
  STORE_STATE(cells, i, waterOnBed(LOAD_STATE(cells, i), at, waterGround, fresh));
}

// Computes the values of a state for drawing and for files. One invocation per cell.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(shownBinding, ShownBlock, shown)
uniform ivec2 size;

vec4 loadWaterAt(int x, int y) {
  return LOAD_INPUT(cells, y * size.x + x);
}
#include "water/model.glsl"
#include "water/look_types.glsl"
layout(std140, binding = stepBinding) uniform LookBlock { WaterLook look; };
#include "water/look.glsl"

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x || y >= size.y) return;
  STORE_STATE(shown, y * size.x + x, waterShown(x, y));
}

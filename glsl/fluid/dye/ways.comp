// For strips.comp: how far through its left and its top face dye goes in a pass, of every cell of the grid and of the ring; 0
// where there is no face.
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = nextFlowBinding) writeonly restrict buffer WayBlock { vec2 ways[]; };

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  vec2 both = vec2(0.0);
  if (x >= 0 && y >= 0) {
    if (y < size.y) both.x = dyeWay(throughU(x, y));
    if (x < size.x) both.y = dyeWay(throughV(x, y));
  }
  ways[elementOf(x, y)] = both;
}

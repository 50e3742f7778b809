// Advects the flow by itself: the first of two passes.
#define NEXT_FLOW
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  storeNext(x, y, carriedCell(x, y));
}

// Computes the flow after a step, except for the pressure correction: second pass of the advection, and forces.
#define NEXT_FLOW
#define PRESSURE_APART
#define READS_KEPT
#define READS_CARRIED
#if SINKS == 1
#define READS_DYE
#endif
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  storeNext(x, y, steppedCell(x, y));
}

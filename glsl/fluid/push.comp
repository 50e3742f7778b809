// Half of what pressure, friction and lift do, and vorticity confinement.
#define PLANES_OUT 4
#include "fluid/grid.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  storeNext(x, y, pushedCell(keptPressure(uintBitsToFloat(control.lastSpeed)), x, y));
}

// Half of what pressure, friction and lift do, and vorticity confinement.
#include "fluid/grid.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  STORE_STATE(nextFlow, elementOf(x, y), pushedCell(keptPressure(uintBitsToFloat(control.lastSpeed)), x, y));
}

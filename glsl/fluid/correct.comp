// The flow after a step but for the pressure's correction: carried along itself, and pushed.
#define PLANES_IN
#define READS_CARRIED
#if SINKS == 1
#define READS_DYE
#endif
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  STORE_STATE(nextFlow, elementOf(x, y), steppedCell(x, y));
}

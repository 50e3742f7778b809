// Takes the slope of the corrections' sum off the flow, continues it into obstacles and around the grid, and looks at what
// it has become.
#define READS_SUM
#include "fluid/grid.glsl"
#include "common/status.glsl"
#include "fluid/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)
uniform uint number;      // of the step, for the status
uniform float lostSpeed;  // cells/s that no flow should have

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  vec4 cell = finishedCell(x, y);
  STORE_STATE(nextFlow, elementOf(x, y), cell);
  if (x < 0 || y < 0 || x >= size.x || y >= size.y) return;
  float speed = max(abs(cell.x), abs(cell.y));
  noteMost(abs(stillMissing(x, y)), speed);
  noteSpeed(speed);
  if (speed > lostSpeed || !isNumber(cell.x) || !isNumber(cell.y) || !isNumber(cell.z)) noteLost(number, uint(y * size.x + x));
}

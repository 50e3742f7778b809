// Takes the slope of the corrections' sum off the flow, mirrors it along obstacles and around the grid, and looks at what it
// has become.
#define READS_SUM
#include "fluid/grid.glsl"
#include "common/status.glsl"
#include "fluid/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)
uniform uint number;  // of the step, for the status

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  vec4 cell = finishedCell(x, y);
  STORE_STATE(nextFlow, elementOf(x, y), cell);
  if (x < 0 || y < 0 || x >= size.x || y >= size.y) return;
  float right = finishedU(faceX(x + 1), y), bottom = finishedV(x, faceY(y + 1));
  precise float out_ = (right - cell.x) + (bottom - cell.y);
  noteMost(isSolid(x, y) ? 0.0 : abs(out_), max(abs(cell.x), abs(cell.y)));
  if (!isNumber(cell.x) || !isNumber(cell.y) || !isNumber(cell.z)) noteLost(number, uint(y * size.x + x));
}

// Measures the flow that project_open.comp, project.comp and settle.comp have produced: remaining divergence, maximum
// speed, and whether values are lost. If WAYS is defined, also computes for dye/strips.comp how far dye moves in a pass
// through the left face and the top face of each cell, 0 if the face does not exist. One invocation per rowsEach rows
// of a column.
#include "fluid/grid.glsl"
#include "common/status.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
#ifdef WAYS
layout(std430, binding = nextFlowBinding) writeonly restrict buffer WayBlock { vec2 ways[]; };
#endif
const int rowsEach = 4;   // Number of rows of a column that an invocation processes
uniform uint number;      // Step number for the status buffer
uniform float lostSpeed;  // Speed in cells/s above which the flow counts as lost

// Returns stillMissing() for a flow that is already projected.
float missingNow(int x, int y) {
  precise float out_ = (throughU(faceX(x + 1), y) - throughU(x, y)) + (throughV(x, faceY(y + 1)) - throughV(x, y));
  precise float missing = growthAt(x, y) - out_;
  return isSolid(x, y) ? 0.0 : missing;
}

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, top = rowsEach * int(gl_GlobalInvocationID.y) - 1;
  float missing = 0.0, maximum = 0.0;
  for (int y = top; y < top + rowsEach; ++y) {
    if (x > size.x || y > size.y) break;
#ifdef WAYS
    vec2 both = vec2(0.0);
    if (x >= 0 && y >= 0) {
      if (y < size.y) both.x = dyeWay(throughU(x, y));
      if (x < size.x) both.y = dyeWay(throughV(x, y));
    }
    ways[elementOf(x, y)] = both;
#endif
    if (x < 0 || y < 0 || x >= size.x || y >= size.y) continue;
    vec4 cell = flowAt(x, y);
    float speed = max(abs(cell.x), abs(cell.y));
    missing = max(missing, abs(missingNow(x, y)));
    maximum = max(maximum, speed);
    if (speed > lostSpeed || !isNumber(cell.x) || !isNumber(cell.y) || !isNumber(cell.z)) noteLost(number, uint(y * size.x + x));
  }
  noteMaximum(missing, maximum, maximum);
}

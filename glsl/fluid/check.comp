// Looks at what project_open.comp, project.comp and settle.comp have made of the flow: what is still missing, how fast it is,
// whether it is lost. And (WAYS) for dye/strips.comp: how far through its left and its top face dye goes in a pass, of every
// cell of the grid and of the ring; 0 where there is no face.
#include "fluid/grid.glsl"
#include "common/status.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
#ifdef WAYS
layout(std430, binding = nextFlowBinding) writeonly restrict buffer WayBlock { vec2 ways[]; };
#endif
const int rowsEach = 4;   // of a column, an invocation
uniform uint number;      // of the step, for the status
uniform float lostSpeed;  // cells/s that no flow should have

// stillMissing of the flow as it is.
float missingNow(int x, int y) {
  precise float out_ = (throughU(faceX(x + 1), y) - throughU(x, y)) + (throughV(x, faceY(y + 1)) - throughV(x, y));
  precise float missing = growthAt(x, y) - out_;
  return isSolid(x, y) ? 0.0 : missing;
}

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, top = rowsEach * int(gl_GlobalInvocationID.y) - 1;
  float missing = 0.0, most = 0.0;
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
    most = max(most, speed);
    if (speed > lostSpeed || !isNumber(cell.x) || !isNumber(cell.y) || !isNumber(cell.z)) noteLost(number, uint(y * size.x + x));
  }
  noteMost(missing, most, most);
}

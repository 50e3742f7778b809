// Computes the maximum speed of the flow, for the first step of a resumed run, which has no previous step.
#include "fluid/grid.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  vec4 cell = flowAt(min(x, size.x - 1), min(y, size.y - 1));
  noteMaximum(0.0, 0.0, max(abs(cell.x), abs(cell.y)));
}

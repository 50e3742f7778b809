// Applies the first half of the step's forces: half of the pressure gradient, viscosity and buoyancy, and the full
// vorticity confinement.
#define NEXT_FLOW
#include "fluid/grid.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
#ifndef TEXEL_PATH
#include "fluid/kept.glsl"
#endif

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  float left = keptPressure(uintBitsToFloat(control.lastSpeed));
#ifndef TEXEL_PATH
  if (x < 0 && y < 0) kept = left;
#endif
  storeNext(x, y, pushedCell(left, x, y));
}

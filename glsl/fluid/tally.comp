// Measures a fluid once per frame (src/sim/fluid/quantities.cpp). Sums u^2 / 2, half the squared curl, the dye and the
// temperature. Determines the maximum of max(|u|, |v|) (for the speed and for the distance per substep), of the
// divergence, and of the cycles per projection.
#define READS_DYE
#include "fluid/grid.glsl"
layout(local_size_x = 64) in;
#include "fluid/solver/solve_control.glsl"

struct Tallied {
  vec4 sums;
  vec4 maximum;
};

Tallied tallied(int cell) {
  int y = cell / size.x, x = cell - y * size.x;
  Tallied t;
  t.sums = vec4(0.0f);
  t.maximum = vec4(0.0f);
  if (cell == 0) {
    precise float cycles = float(int(control.cycles)) * exactReciprocal(max(float(int(control.solved)), 1.0f));
    t.maximum.z = uintBitsToFloat(control.worstShare);
    t.maximum.w = cycles;
  }
  t.sums.z = densityOf(dyeAt(x, y));
  if (isSolid(x, y)) return t;
  vec4 here = flowAt(x, y);
  float right = flowAt(x + 1, y).x, below = flowAt(x, y + 1).y;
  precise float energy = 0.25f * ((here.x * here.x + right * right) + (here.y * here.y + below * below));
  float speed = max(abs(here.x), abs(here.y));
  t.sums.x = energy;
  t.sums.w = here.z;
  t.maximum.x = speed;
  t.maximum.y = speed;
  bool inner = x > 0 && y > 0;
  if (!inner || isSolid(x - 1, y) || isSolid(x, y - 1) || isSolid(x - 1, y - 1)) return t;
  precise float curl = (here.y - flowAt(x - 1, y).y) - (here.x - flowAt(x, y - 1).x);
  precise float square = 0.5f * curl * curl;
  t.sums.y = square;
  return t;
}
#include "grid/tally.glsl"

void main() {
  int lane = int(gl_GlobalInvocationID.x);
  if (lane >= tallyLanes) return;
  tallyLane(lane, size.x * size.y);
}

// Decides whether another cycle is needed. If not, sets the sizes of all following dispatches to 0. Runs before the
// first cycle and after each cycle. If JUDGE is defined, it instead evaluates the projected flow once at the end.
#include "common/exact.glsl"
#include "common/status.glsl"
#include "fluid/bindings.glsl"
#include "fluid/solver/solve_control.glsl"
const int lanes = 64;
layout(local_size_x = lanes) in;
uniform int dispatches;    // Number of indirect dispatches in control.groups
uniform int first;         // 1 for the dispatch before the first cycle
uniform float tolerance;   // Maximum allowed ratio of `flow` to `speed`
uniform float maxSpeed;   // Maximum expected speed, given by the scene

void main() {
  float flow = uintBitsToFloat(control.flow), speed = uintBitsToFloat(control.speed);
#ifdef JUDGE
  if (gl_LocalInvocationIndex > 0u) return;
  float each = exactReciprocal(max(speed, 1e-20));
  precise float share = speed > 1e-20 ? flow * each : 0.0;
  control.lastShare = floatBitsToUint(share);
  control.worstShare = max(control.worstShare, control.lastShare);
  control.worstSpeed = max(control.worstSpeed, control.lastSpeed);
  control.solved += 1u;
  if (share > tolerance) status.remark |= 1u;
  if (uintBitsToFloat(control.lastSpeed) > maxSpeed) status.remark |= 2u;
  control.flow = 0u;
  control.speed = 0u;
#else
  precise float maximum = tolerance * speed;
  // During the cycles, the last dispatch always has a nonzero size. If its size is 0, an earlier decision has ended the
  // solve.
  bool met = flow <= maximum, over = first == 0 && control.groups[3 * dispatches - 1] == 0u;
  barrier();
  if (over) return;
  int lane = int(gl_LocalInvocationIndex);
  for (int i = lane; i < 3 * dispatches; i += lanes) control.groups[i] = met ? 0u : control.groups[3 * dispatches + i];
  if (lane > 0) return;
  if (first == 1) control.lastSpeed = 0u;
  if (first == 1) control.begun = 0u;
  if (!met) {
    control.cycles += 1u;
    control.begun += 1u;
  }
  control.flow = 0u;
#endif
}

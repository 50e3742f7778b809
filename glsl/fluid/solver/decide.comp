// Whether another cycle is needed: if not, the dispatches of all that follow become empty. Before the first one, after each,
// and (JUDGE) once more of what the projected flow is.
#include "common/exact.glsl"
#include "common/status.glsl"
#include "fluid/bindings.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 1) in;
uniform int dispatches;    // whose groups stand in control.groups
uniform int first;         // 1: before the first cycle
uniform float tolerance;   // of flow / speed
uniform float mostSpeed;   // what the scene says

void main() {
  float flow = uintBitsToFloat(control.flow), speed = uintBitsToFloat(control.speed);
#ifdef JUDGE
  float each = exactReciprocal(max(speed, 1e-20));
  precise float share = speed > 1e-20 ? flow * each : 0.0;
  control.lastShare = floatBitsToUint(share);
  control.worstShare = max(control.worstShare, control.lastShare);
  control.worstSpeed = max(control.worstSpeed, control.lastSpeed);
  control.solved += 1u;
  if (share > tolerance) status.remark |= 1u;
  if (uintBitsToFloat(control.lastSpeed) > mostSpeed) status.remark |= 2u;
  control.flow = 0u;
  control.speed = 0u;
#else
  precise float most = tolerance * speed;
  bool met = flow <= most;
  if (first == 1) control.lastSpeed = 0u;
  if (first == 0 && control.groups[3 * dispatches - 1] == 0u) return;  // of the last, which a cycle always has
  for (int i = 0; i < 3 * dispatches; ++i) control.groups[i] = met ? 0u : control.groups[3 * dispatches + i];
  if (!met) control.cycles += 1u;
  control.flow = 0u;
#endif
}

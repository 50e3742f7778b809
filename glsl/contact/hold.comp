// Limits the paths of vertices that would pass through each other. One invocation per near pair. Rounds 0 to 2 limit
// the corners of pairs that not even a moving plane separates, after applying the limits of the earlier rounds. Round 3
// only tests: if a pair still fails, all vertices use the limits for planes that stand still.
#include "contact/kernel.glsl"
#include "contact/near_list.glsl"
uniform int round;

void main() {
  int i = nearIndex();
  if (i >= nearsThere()) return;
  Near near = nearAt(i);
  ivec4 c = cornersOf(near);
  vec4 let = vec4(1.0f);
  for (int k = 0; k < 4 && round > 0; ++k) {
    ivec4 lets = LOAD_TALLY(pathFractionTally(c[k]));
    let[k] = intBitsToFloat(min(lets.x, round > 1 ? lets.y : lets.x));
    if (round > 2) let[k] = min(let[k], intBitsToFloat(lets.z));
  }
  if (round > 0 && let == vec4(1.0f)) return;  // If no corner has been limited, the result of round 0 is still valid.
  vec4 heights = heightsOf(near, pointAt(nowSection, c.x).xyz, pointAt(nowSection, c.y).xyz, pointAt(nowSection, c.z).xyz,
                           pointAt(nowSection, c.w).xyz);
  vec4 starts = heightsOf(near, startOf(c.x), startOf(c.y), startOf(c.z), startOf(c.w));
  vec4 rises = heightsOf(near, wayFromStart(c.x), wayFromStart(c.y), wayFromStart(c.z), wayFromStart(c.w));
  float thick = thicknessOf(c);
  bool through = passes(near, heights, starts, rises, let, thick);
  if (round == 3) {
    // Pairs with a solid are not tested. Their planes do not depend on other cloth, so the pairs stay separated.
    if (through && !meetsSolid(near)) control.stopped = 1u;
    return;
  }
  if (!through && round > 0) return;
  vec4 own = letOf(near, heights, starts, rises, thick);
  for (int k = 0; k < 4; ++k) {
    int bits = floatBitsToInt(own[k]);  // The bits of non-negative floats compare like the floats.
    if (own[k] == 1.0f) continue;
    if (round == 0) atomicMin(tallies[pathFractionTally(c[k])].w, bits);
    if (!through) continue;
    if (round == 0) atomicMin(tallies[pathFractionTally(c[k])].x, bits);
    if (round == 1) atomicMin(tallies[pathFractionTally(c[k])].y, bits);
    if (round == 2) atomicMin(tallies[pathFractionTally(c[k])].z, bits);
  }
}

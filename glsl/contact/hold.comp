// Holds back what would pass through: in the rounds 0 to 2 corners of pairs that do so even with a moving plane between them,
// as those rounds have left the others; the last round only sees whether any still do, and if so, planes at rest hold all.
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
    ivec4 lets = LOAD_TALLY(letTally(c[k]));
    let[k] = intBitsToFloat(min(lets.x, round > 1 ? lets.y : lets.x));
    if (round > 2) let[k] = min(let[k], intBitsToFloat(lets.z));
  }
  if (round > 0 && let == vec4(1.0f)) return;  // as before
  vec4 heights = heightsOf(near, pointAt(nowSection, c.x).xyz, pointAt(nowSection, c.y).xyz, pointAt(nowSection, c.z).xyz,
                           pointAt(nowSection, c.w).xyz);
  vec4 starts = heightsOf(near, startOf(c.x), startOf(c.y), startOf(c.z), startOf(c.w));
  vec4 rises = heightsOf(near, wayFromStart(c.x), wayFromStart(c.y), wayFromStart(c.z), wayFromStart(c.w));
  float thick = thicknessOf(c);
  bool through = passes(near, heights, starts, rises, let, thick);
  if (round == 3) {
    if (through && !meetsSolid(near)) control.stopped = 1u;  // a cloth that is off a solid stays so whatever others do
    return;
  }
  if (!through && round > 0) return;
  vec4 own = letOf(near, heights, starts, rises, thick);
  for (int k = 0; k < 4; ++k) {
    int bits = floatBitsToInt(own[k]);  // which are in the floats' order, as these are not negative
    if (own[k] == 1.0f) continue;
    if (round == 0) atomicMin(tallies[letTally(c[k])].w, bits);
    if (!through) continue;
    if (round == 0) atomicMin(tallies[letTally(c[k])].x, bits);
    if (round == 1) atomicMin(tallies[letTally(c[k])].y, bits);
    if (round == 2) atomicMin(tallies[letTally(c[k])].z, bits);
  }
}

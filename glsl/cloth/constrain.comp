// One colour of one family of XPBD constraints: no particle belongs to two constraints of a colour, so
// all of them may move their ends at once.
#include "cloth/kernel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#if DAMPED
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
#endif
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
uniform ivec2 reach;  // from one end to the other, in particles
uniform int color;    // 0 or 1
uniform int kind;   // 0 structural, 1 shear, 2 bend

vec4 loadPosition(int i) {
  return LOAD_ONCE(nextPositions, i);
}
#include "cloth/model.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 to = at + reach;
  if (at.x >= size.x || at.y >= size.y || to.x < 0 || to.x >= size.x || to.y >= size.y) return;
  int along = reach.x > 0 ? at.x / reach.x : at.y / reach.y;
  if ((along & 1) != color) return;
  int i = at.y * size.x + at.x;
  int j = to.y * size.x + to.x;
  vec4 a = loadPosition(i);
  vec4 b = loadPosition(j);
  float kept = 0.0f;
#if DAMPED
  kept = keptStretch(LOAD_INPUT(positions, i), LOAD_INPUT(positions, j), springLength(kind));
#endif
  vec3 shift = constraintShift(a, b, springLength(kind), scaledCompliance(kind), kept);
  precise vec3 newA = a.xyz - shift * a.w;
  precise vec3 newB = b.xyz + shift * b.w;
  STORE_STATE(nextPositions, i, vec4(newA, a.w));
  STORE_STATE(nextPositions, j, vec4(newB, b.w));
}

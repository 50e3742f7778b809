// Stitches of the seams, of one colour: they share no vertex.
#include "cloth/mesh/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(stitchesBinding, StitchBlock, stitches)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
uniform int first;  // stitch of the colour
#include "cloth/mesh/membrane.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  uvec4 stitch = LOAD_INPUT_WORDS(stitches, first + k);
  vec4 a = LOAD_ONCE(nextPositions, int(stitch.x));
  vec4 b = LOAD_ONCE(nextPositions, int(stitch.y));
  vec3 shift = stitchShift(a, b, intBitsToFloat(int(stitch.z)), intBitsToFloat(int(stitch.w)));
  STORE_STATE(nextPositions, int(stitch.x), shifted(a, shift));
  STORE_STATE(nextPositions, int(stitch.y), shifted(b, -shift));
}

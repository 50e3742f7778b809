// Solves the stitches of one colour. Stitches of one colour have no vertex in common. One invocation per stitch.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(stitchesBinding, StitchBlock, stitches)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
uniform int first;  // Index of the colour's first stitch
#include "garment/membrane.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  uvec4 stitch = LOAD_INPUT_WORDS(stitches, first + k);
  vec4 a = LOAD_ONCE(nextPositions, int(stitch.x));
  vec4 b = LOAD_ONCE(nextPositions, int(stitch.y));
  vec3 shift = stitchShift(a, b, intBitsToFloat(int(stitch.z)), intBitsToFloat(int(stitch.w)));
  vec4 movedA = shifted(a, shift), movedB = shifted(b, -shift);
  STORE_STATE(nextPositions, int(stitch.x), movedA);
  STORE_STATE(nextPositions, int(stitch.y), movedB);
  STORE_STATE(velocities, int(stitch.x), pushed(LOAD_ONCE(velocities, int(stitch.x)), a, movedA));
  STORE_STATE(velocities, int(stitch.y), pushed(LOAD_ONCE(velocities, int(stitch.y)), b, movedB));
}

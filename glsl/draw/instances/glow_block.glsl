// Light of additive sprites as 64-bit integers in units of 2^-24, so that the sums do not depend on the order in which
// kernels add. A pixel has six words: the lower words of r, g, b, then the upper words.
layout(std430, binding = glowBinding) restrict buffer GlowBlock { uint glowSums[]; };

const float glowUnits = 16777216.0;  // integer units in a light value of 1
const float glowUpper = 256.0;       // light value of one unit of the upper word
const float perGlowUpper = 0.00390625;

#ifndef GLOW_FIRST_ROW
#define GLOW_FIRST_ROW 0
#endif

int glowWord(ivec2 pixel) {
  return 6 * ((pixel.y - GLOW_FIRST_ROW) * int(frame.size.x) + pixel.x);
}

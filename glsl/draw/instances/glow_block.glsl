// Light of additive sprites as whole numbers of 64 bits, in units of 2^-24: kernels may add it in any order and the sums
// are the same. Six words a pixel of the scene: the lower ones of r, g, b, then the upper ones.
layout(std430, binding = glowBinding) restrict buffer GlowBlock { uint glowSums[]; };

const float glowUnits = 16777216.0;  // of light 1
const float glowUpper = 256.0;       // light that the upper word counts
const float perGlowUpper = 0.00390625;

#ifndef GLOW_FIRST_ROW
#define GLOW_FIRST_ROW 0
#endif

int glowWord(ivec2 pixel) {
  return 6 * ((pixel.y - GLOW_FIRST_ROW) * int(frame.size.x) + pixel.x);
}

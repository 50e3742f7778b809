// Light of additive sprites as whole numbers, three words (r, g, b) a pixel of the scene: kernels may add them in any
// order and the sums are the same.
layout(std430, binding = 1) restrict buffer GlowBlock { uint glowSums[]; };
uniform float glowScale;  // of light 1

// Weights of the texels of a level around the middle of a texel of one twice as large. Compiles as GLSL and as C++.
//
// The middle of texel i lies at i / 2 - 1/4 between texels of half the size: a quarter of one before or behind texel
// i / 2.

// The first of two texels, and the weight of the second.
FUNCTION int firstHalfTexel(int i) {
  return (i - 1) >> 1;
}
FUNCTION float secondWeight(int i) {
  return (i & 1) == 0 ? 0.75f : 0.25f;
}

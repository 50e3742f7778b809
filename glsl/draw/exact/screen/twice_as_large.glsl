// Interpolation weights for reading a level at twice its size. Compiles as GLSL and as C++.
// In the half-size level, the centre of texel i is at i / 2 - 1/4, a quarter of a texel before or behind the centre of
// texel i / 2.

// Returns the first of the two texels; secondWeight() returns the weight of the second.
FUNCTION int firstHalfTexel(int i) {
  return (i - 1) >> 1;
}
FUNCTION float secondWeight(int i) {
  return (i & 1) == 0 ? 0.75f : 0.25f;
}

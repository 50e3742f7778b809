// Half pixels of a tile: what is found once for four pixels.
const int halfPixels = 16;

// Pixel number k of half pixel number i.
ivec2 pixelOfHalf(ivec2 corner, int i, int k) {
  return corner + 2 * ivec2(i & 3, i >> 2) + ivec2(k & 1, k >> 1);
}

// The first of them that has samples (a bit each).
int firstOf(ivec4 samples) {
  return samples.x != 0 ? 0 : samples.y != 0 ? 1 : samples.z != 0 ? 2 : 3;
}

void addToHalf(ivec2 corner, int i, vec4 light, ivec4 samples) {
  bool any_ = light.r != 0.0f || light.g != 0.0f || light.b != 0.0f;
  for (int k = any_ ? 0 : 4; k < 4; ++k)
    if (samples[k] != 0) addLight(pixelOfHalf(corner, i, k), light, samples[k]);
}

// Half pixels (blocks of 2x2 pixels) of a tile, for values that four pixels have in common.
const int halfPixels = 16;

// Returns pixel k (0 to 3) of half pixel i.
ivec2 pixelOfHalf(ivec2 corner, int i, int k) {
  return corner + 2 * ivec2(i & 3, i >> 2) + ivec2(k & 1, k >> 1);
}

// Returns the index of the first pixel whose sample mask is not empty.
int firstOf(ivec4 samples) {
  return samples.x != 0 ? 0 : samples.y != 0 ? 1 : samples.z != 0 ? 2 : 3;
}

void addToHalf(ivec2 corner, int i, vec4 light, ivec4 samples) {
  bool any_ = light.r != 0.0f || light.g != 0.0f || light.b != 0.0f;
  for (int k = any_ ? 0 : 4; k < 4; ++k)
    if (samples[k] != 0) addLight(pixelOfHalf(corner, i, k), light, samples[k]);
}

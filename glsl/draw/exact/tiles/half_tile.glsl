// Half pixels (blocks of 2x2 pixels) of a tile, for values that four pixels have in common. REFLECTED kernels write the
// change of light to a picture of its own, which draw/exact/reflections/spread.comp adds to the light.
#include "draw/exact/reflections/refined.glsl"

// Returns pixel k (0 to 3) of half pixel i.
ivec2 pixelOfHalf(ivec2 corner, int i, int k) {
  return corner + 2 * ivec2(i & 3, i >> 2) + ivec2(k & 1, k >> 1);
}

// Returns the index of the first pixel whose sample mask is not empty.
int firstOf(ivec4 samples) {
  return samples.x != 0 ? 0 : samples.y != 0 ? 1 : samples.z != 0 ? 2 : 3;
}

// Adds the change of a half pixel's light to its pixels. `part` is the number of the part that the samples in the masks
// show. Alpha of pixel 0 receives the number and the mask of the pixels that show only this part, if pixel 0 is one of
// them (spread.comp).
void addToHalf(ivec2 corner, int i, vec4 light, ivec4 samples, uint part) {
  int whole = 0;
  for (int k = 0; k < 4; ++k) whole |= bitCount(samples[k]) == SAMPLES ? 1 << k : 0;
  bool any_ = light.r != 0.0f || light.g != 0.0f || light.b != 0.0f;
  float named = (whole & 1) != 0 ? float((part & 0xfffffu) << 4 | uint(whole)) : 0.0f;
  for (int k = any_ || named > 0.0f ? 0 : 1; k < (any_ ? 4 : 1); ++k) {
    if (samples[k] == 0) continue;
    ivec2 pixel = pixelOfHalf(corner, i, k);
    vec4 sum = withLight(pixel, imageLoad(sums, pixel), light, samples[k]);
    imageStore(sums, pixel, vec4(sum.rgb, k == 0 && named > 0.0f ? named : sum.a));
  }
}

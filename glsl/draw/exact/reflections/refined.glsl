// Inputs of kernels with REFLECTED. A half pixel (2x2 pixels) is uneven if its reflection differs from a neighbour's
// (uneven.comp). With refined = 1, the kernels trace a ray for each pixel of uneven half pixels, else for each half pixel.
#ifndef EXACT_REFINED
#define EXACT_REFINED
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
layout(rgba32f, binding = lightImage) readonly restrict uniform image2D litPixels;         // light without reflections
layout(r32ui, binding = unevenImage) readonly restrict uniform uimageBuffer unevenTiles;  // masks of uneven half pixels
uniform int refined;  // 1 to trace a ray for each pixel of the uneven half pixels
int refined_ = once(refined);

// Returns the mask of the half pixels of a tile for which rays are traced.
int halfPixelsToTrace(ivec2 corner) {
  int across = (view.size.x + 7) >> 3, uneven = 0xffff;
  IF_ANY(refined_ != 0)
    uneven = int(imageLoad(unevenTiles, (corner.y >> 3) * across + (corner.x >> 3)).x);
  return uneven;
}

// Returns the number of rays for the half pixels in the mask.
int raysToTrace(int halfPixels_) {
  return bitCount(halfPixels_) << (2 * refined_);
}

// Returns, for ray i, the index of the half pixel in its tile (x) and the mask of the pixels of the half pixel that
// show the reflection (y).
ivec2 rayToTrace(int halfPixels_, int i) {
  ivec2 found = ivec2(i, 15);
  IF_ANY(refined_ != 0) {
    for (int k = i >> 2; k > 0; --k) halfPixels_ &= halfPixels_ - 1;
    found = ivec2(findLSB(halfPixels_), 1 << (i & 3));
  }
  return found;
}
#endif

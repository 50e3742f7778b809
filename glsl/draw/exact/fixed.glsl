// Fixed-point positions in the picture. Triangle corners are in 1/256 pixel, samples in 1/16 pixel. Compiles as GLSL
// and as C++.
#ifndef EXACT_FIXED
#define EXACT_FIXED
#include "common/exact.glsl"

const int subpixels = 256;   // fixed-point steps per pixel for the positions of triangle corners
const int guardPixels = 1024;  // width (pixels) of the guard band around the picture; triangles that extend beyond the
                               // band are clipped
const int tileSide = 8;      // side of a tile in pixels

// Returns 1 / SAMPLES.
FUNCTION float perSamples() {
  return SAMPLES == 1 ? 1.0f : SAMPLES == 2 ? 0.5f : SAMPLES == 4 ? 0.25f : SAMPLES == 8 ? 0.125f : 0.0625f;
}

// Returns the position of sample s in 1/16 pixel from the pixel's top left corner. The positions are the usual
// multisample patterns, in which each row and column contains at most one sample. The constants hold four bits per
// sample, the first sample in the lowest bits.
FUNCTION ivec2 samplePlace(int s) {
  uint x = 8u, y = 8u;
  int shift = (s & 7) * 4;
  if (SAMPLES == 2) x = y = 0x4cu >> shift;
  if (SAMPLES == 4) x = 0xa2e6u >> shift, y = 0xea62u >> shift;
  if (SAMPLES == 8) x = 0xfb135d79u >> shift, y = 0x1f7d39b5u >> shift;
  if (SAMPLES == 16) {
    x = (s < 8 ? 0xbda3c579u : 0x1ef02486u) >> shift;
    y = (s < 8 ? 0x3bd67a59u : 0x0f48c21eu) >> shift;
  }
  return ivec2(x & 15u, y & 15u);
}
#endif

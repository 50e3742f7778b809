// Writes the nearness of the nearest sample in each half pixel (block of 2x2 pixels) of the current band of picture
// rows. GROUND: the ground counts too. PIXELS: also writes the nearness of the nearest object in each pixel, without the
// ground. One invocation handles ROWS vertically adjacent half pixels. SAMPLES: samples
// per pixel. PAIRED: as in draw/exact/sample_read.glsl.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/occlusion/ground_nearness.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(std430, binding = halfPixelBinding) writeonly restrict buffer NearnessBlock { float nearness[]; };
#ifdef PIXELS
layout(std430, binding = pixelNearnessBinding) writeonly restrict buffer PixelNearnessBlock { float pixelNearness[]; };
uniform int firstPixel;  // place of the first pixel in the block
#endif

uint nearestKey(ivec2 pixel) {
  int first = firstSample(pixel);
  uint key = 0xffffffffu;
#if SAMPLES < 4
  for (int s = 0; s < SAMPLES; ++s) key = min(key, keyAt(first + s));
#else
  for (int s = 0; s < SAMPLES; s += 4) {
    uvec4 four = fourKeysAt(first + s);
    key = min(key, min(min(four.x, four.y), min(four.z, four.w)));
  }
#endif
  return key;
}

float nearOfKey(uint key) {
  return key <= 0x7fffffffu ? intBitsToFloat(int(0x7fffffffu - key)) : 0.0f;
}

float nearnessOf(ivec2 at) {
  ivec2 first = 2 * at, last = min(first + 1, ivec2(view.size.x, view.rows.y) - 1);
  uvec4 keys = uvec4(nearestKey(first), nearestKey(ivec2(last.x, first.y)), nearestKey(ivec2(first.x, last.y)), nearestKey(last));
  float near = nearOfKey(min(min(keys.x, keys.y), min(keys.z, keys.w)));
#ifdef PIXELS
  for (int k = 0; k < 4; ++k) {
    ivec2 pixel = first + ivec2(k & 1, k >> 1);
    if (pixel.x > last.x || pixel.y > last.y) continue;
    float shown = nearOfKey(keys[k]);
    precise vec2 middle = vec2(pixel) + 0.5f;
#ifdef GROUND
    IF_ANY(shown > 0.0f) shown = shown > groundNearnessAt(middle) ? shown : 0.0f;
#endif
    pixelNearness[firstPixel + pixel.y * view.size.x + pixel.x] = nearnessPerMetre(shown);
  }
#endif
#ifdef GROUND
  near = max(near, groundNearness(at));
#endif
  return nearnessPerMetre(near);
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS) + ivec2(0, view.rows.x / 2);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (2 * at.x < view.size.x && 2 * at.y < view.rows.y) nearness[at.y * ((view.size.x + 1) / 2) + at.x] = nearnessOf(at);
  }
}

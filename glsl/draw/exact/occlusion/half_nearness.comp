// Writes the nearness of the nearest sample in each half pixel (block of 2x2 pixels) of the current band of picture
// rows. GROUND: the ground counts too. One invocation handles ROWS vertically adjacent half pixels. SAMPLES: samples
// per pixel. PAIRED: as in draw/exact/sample_read.glsl.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/occlusion/ground_nearness.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(std430, binding = halfPixelBinding) writeonly restrict buffer NearnessBlock { float nearness[]; };

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

float nearnessOf(ivec2 at) {
  ivec2 first = 2 * at, last = min(first + 1, ivec2(view.size.x, view.rows.y) - 1);
  uint key = min(min(nearestKey(first), nearestKey(ivec2(last.x, first.y))),
                 min(nearestKey(ivec2(first.x, last.y)), nearestKey(last)));
  float near = key <= 0x7fffffffu ? intBitsToFloat(int(0x7fffffffu - key)) : 0.0f;
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

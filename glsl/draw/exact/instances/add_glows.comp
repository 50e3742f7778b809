// Adds the sums of glows to the light of the picture and clears the sums. One invocation handles one pixel.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#define GLOW_FIRST_ROW view.rows.x
#include "draw/instances/glow_block.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (pixel.x >= view.size.x || pixel.y >= view.rows.y) return;
  int word = glowWord(pixel);
  precise vec4 light = imageLoad(sums, pixel);
  uint any_ = 0u;
  for (int i = 0; i < 3; ++i) {
    uint lower = glowSums[word + i], upper = glowSums[word + 3 + i];
    any_ |= lower | upper;
    // Converts each word as two 16-bit halves, because floats hold 16-bit integers exactly, while drivers round larger
    // ones differently.
    precise float fine = float(lower & 0xffffu) * 5.9604645e-8f + float(lower >> 16) * 0.00390625f;
    precise float sum = light[i] + (float(min(upper, 0xffffffu)) * glowUpper + fine);
    light[i] = sum;
  }
  if (any_ == 0u) return;
  imageStore(sums, pixel, light);
  for (int i = 0; i < 6; ++i) glowSums[word + i] = 0u;
}

// Writes the nearness of the nearest sample of each pixel of the current band, for lens_shift.comp; 0 if the pixel is
// empty. GROUND: the ground counts too. SAMPLES: samples per pixel. PAIRED: as in draw/exact/sample_read.glsl. One
// invocation handles one pixel.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/ground_plane.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f, binding = nearnessImage) writeonly restrict uniform image2D nearness;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (at.x >= view.size.x || at.y >= view.rows.y) return;
  uint key = 0xffffffffu;
  int first = firstSample(at);
  for (int s = 0; s < SAMPLES; ++s) key = min(key, keyAt(first + s));
  float near = key <= 0x7fffffffu ? intBitsToFloat(int(0x7fffffffu - key)) : 0.0f;
#ifdef GROUND
  precise vec2 middle = vec2(at) + 0.5f;
  float depth = groundDepth(rayThrough(middle));
  float ground = nearOf(depth);
  if (depth >= view.near && ground >= view.nearOverFar) near = max(near, ground);
#endif
  imageStore(nearness, at, vec4(near));
}

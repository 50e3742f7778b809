// Smooths the occluded and total ambient light of half pixels (blocks of 2x2 pixels) along rows. DOWN: smooths along
// columns and writes the openness (draw/exact/occlusion/smooth_arcs.glsl) and nearness of each half pixel. One
// invocation handles ROWS adjacent half pixels in the smoothing direction, in groups that share their reads.
#define EXACT_PICTURE
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer nearness;
layout(rg32f, binding = arcImage) readonly restrict uniform imageBuffer arcs;
#ifdef DOWN
layout(std430, binding = halfPixelBinding) writeonly restrict buffer OpennessBlock { vec2 openness[]; };
const ivec2 along = ivec2(0, 1);
#else
layout(std430, binding = halfPixelBinding) writeonly restrict buffer SmoothBlock { vec2 smooth_[]; };
const ivec2 along = ivec2(1, 0);
#endif
const int atOnce = min(ROWS, 4);
ivec2 halfSize = (view.size + 1) / 2;
#include "draw/exact/occlusion/smooth_arcs.glsl"

vec3 arcsAt(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), halfSize - 1);
  int place = held.y * halfSize.x + held.x;
  vec3 found = vec3(imageLoad(arcs, place).xy, imageLoad(nearness, place).x);
  return held == at ? found : vec3(0.0f);
}

void smoothAtOnce(ivec2 first) {
  vec3 seen[atOnce + 6];
  for (int k = 0; k < atOnce + 6; ++k) seen[k] = arcsAt(first + along * (k - 3));
  float nearest = 0.0f;
  vec2 sums[atOnce];
  for (int i = 0; i < atOnce; ++i) {
    nearest = max(nearest, seen[i + 3].z);
    sums[i] = vec2(0.0f, 1.0f);
  }
  IF_ANY(nearest > 0.0f)
    for (int i = 0; i < atOnce; ++i) {
      ArcsBeside beside;
      for (int k = 0; k < 7; ++k) beside.of[k] = seen[i + k];
      vec2 smoothed = smoothArcs(beside);
      sums[i] = seen[i + 3].z > 0.0f ? smoothed : sums[i];
    }
  for (int i = 0; i < atOnce; ++i) {
    ivec2 at = first + along * i;
    if (at.x >= halfSize.x || at.y >= halfSize.y) continue;
#ifdef DOWN
    openness[at.y * halfSize.x + at.x] = vec2(opennessOf(sums[i]), seen[i + 3].z);
#else
    smooth_[at.y * halfSize.x + at.x] = sums[i];
#endif
  }
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * (1 + along * (ROWS - 1));
  for (int begin = 0; begin < ROWS; begin += atOnce) smoothAtOnce(first + along * begin);
}

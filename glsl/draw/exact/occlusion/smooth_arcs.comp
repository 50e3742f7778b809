// Smooths what is lost of the surroundings' light along rows, or, DOWN, along columns, which is how open each half pixel is
// (draw/exact/occlusion/smooth_arcs.glsl), and how near. An invocation does ROWS half pixels, one below the other.
#define EXACT_PICTURE
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(rgba32f, binding = arcImage) readonly restrict uniform imageBuffer arcs;
#ifdef DOWN
layout(std430, binding = halfPixelBinding) writeonly restrict buffer OpennessBlock { vec2 openness[]; };
const ivec2 along = ivec2(0, 1);
#else
layout(std430, binding = halfPixelBinding) writeonly restrict buffer SmoothBlock { vec4 smooth_[]; };
const ivec2 along = ivec2(1, 0);
#endif
ivec2 halfSize = (view.size + 1) / 2;

vec4 arcsAt(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), halfSize - 1);
  vec4 found = imageLoad(arcs, held.y * halfSize.x + held.x);
  return held == at ? found : vec4(0.0f);
}
#include "draw/exact/occlusion/smooth_arcs.glsl"

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (at.x >= halfSize.x || at.y >= halfSize.y) continue;
    float here = arcsAt(at).z;
    // In a loop, which ends at once where nothing is: software drivers run both sides of a branch.
    vec2 sums = vec2(0.0f, 1.0f);
    for (int i = here > 0.0f ? 0 : 1; i < 1; ++i) sums = smoothArcs(at, along);
#ifdef DOWN
    openness[at.y * halfSize.x + at.x] = vec2(opennessOf(sums), here);
#else
    smooth_[at.y * halfSize.x + at.x] = vec4(sums, here, 0.0f);
#endif
  }
}

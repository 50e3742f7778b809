// Smooths what is lost of the surroundings' light along rows, or, DOWN, along columns, which is how open each half pixel is
// (draw/exact/occlusion/smooth_arcs.glsl), and how near. An invocation does ROWS half pixels, one below the other.
#define EXACT_PICTURE
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(rgba32f, binding = arcImage) readonly restrict uniform image2D arcs;
#ifdef DOWN
layout(rg32f, binding = opennessImage) writeonly restrict uniform image2D openness;
const ivec2 along = ivec2(0, 1);
#else
layout(rgba32f, binding = smoothArcImage) writeonly restrict uniform image2D smooth_;
const ivec2 along = ivec2(1, 0);
#endif
ivec2 halfSize = (view.size + 1) / 2;

vec4 arcsAt(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), halfSize - 1);
  vec4 found = imageLoad(arcs, held);
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
    imageStore(openness, at, vec4(opennessOf(sums), here, 0.0f, 0.0f));
#else
    imageStore(smooth_, at, vec4(sums, here, 0.0f));
#endif
  }
}

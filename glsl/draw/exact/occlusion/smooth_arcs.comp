// How open each half pixel is to the surroundings' light, and how near (draw/exact/occlusion/smooth_arcs.glsl). An invocation does
// ROWS half pixels, one below the other.
#define EXACT_PICTURE
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(r32f, binding = nearnessImage) readonly restrict uniform image2D nearness;
layout(rg32f, binding = arcImage) readonly restrict uniform image2D arcs;
layout(rg32f, binding = opennessImage) writeonly restrict uniform image2D openness;
ivec2 halfSize = (view.size + 1) / 2;

float nearnessAt(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), halfSize - 1);
  float found = imageLoad(nearness, held).x;
  return held == at ? found : 0.0f;
}
vec2 arcsAt(ivec2 at) {
  return imageLoad(arcs, clamp(at, ivec2(0), halfSize - 1)).xy;
}
#include "draw/exact/occlusion/smooth_arcs.glsl"

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (at.x >= halfSize.x || at.y >= halfSize.y) continue;
    float here = nearnessAt(at), open = 1.0f;
    for (int i = here > 0.0f ? 0 : 1; i < 1; ++i) open = opennessOf(at, here);
    imageStore(openness, at, vec4(open, here, 0.0f, 0.0f));
  }
}

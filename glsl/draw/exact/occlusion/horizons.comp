// Computes the occluded and the total ambient light of each half pixel (block of 2x2 pixels) by
// draw/exact/occlusion/horizons.glsl. One invocation handles ROWS vertically adjacent half pixels. SLICES: number of
// slices per half pixel. STEPS: number of samples along each of the two directions of a slice.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer nearness;
layout(std430, binding = halfPixelBinding) writeonly restrict buffer ArcBlock { vec2 arcs[]; };
uniform vec3 reach;  // x: max distance of occluders (m); y: the same in half pixels; z: half pixels per metre at depth
                     // 1
vec3 reach_ = once(reach);
ivec2 halfSize = (view.size + 1) / 2;

float nearnessAt(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), halfSize - 1);
  float found = imageLoad(nearness, held.y * halfSize.x + held.x).x;
  return held == at ? found : 0.0f;
}
#include "draw/exact/occlusion/horizons.glsl"

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (at.x >= halfSize.x || at.y >= halfSize.y) continue;
    float here = nearnessAt(at);
    Arcs found = Arcs(0.0f, 0.0f);
    IF_ANY(here > 0.0f) found = arcsOf(halfPlaceOf(at, here));
    arcs[at.y * halfSize.x + at.x] = vec2(found.lost, found.all_);
  }
}

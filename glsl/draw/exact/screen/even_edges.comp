// Expands the compressed light of the band's pixels that show several primitives, before other passes read or change the
// light (edge_light.glsl). One invocation handles one pixel.
#define EXACT_PICTURE
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/screen/edge_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
uniform int linear;  // 1 if the averages are linear

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (at.x >= view.size.x || at.y >= view.rows.y) return;
  vec4 light = imageLoad(sums, at);
  IF_ANY(light.a < 0.0f)
    imageStore(sums, at, min(evenedLight(light, linear == 1 ? 0.0f : frame.exposure), 6e4f));
}

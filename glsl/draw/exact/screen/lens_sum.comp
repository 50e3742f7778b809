// Averages the light of several renderings, one for each lens point. Each dispatch adds the light in `sums` to the
// total; the last one writes the mean to `sums`. One invocation handles one pixel.
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
layout(rgba32f, binding = lightImage) restrict uniform image2D total;
uniform int first;    // 1 if `sums` holds the light of the first lens point
uniform float share;  // 1 / number of lens points if this is the last lens point; otherwise 0

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= view.size.x || at.y >= view.size.y) return;
  precise vec4 sum = min(imageLoad(sums, at), 6e4f) + (first == 1 ? vec4(0.0) : imageLoad(total, at));
  precise vec4 mean = sum * share;
  if (share > 0.0)
    imageStore(sums, at, mean);
  else
    imageStore(total, at, sum);
}

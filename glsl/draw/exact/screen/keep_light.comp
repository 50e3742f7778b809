// Copies the light of a band of the picture. One invocation copies one pixel.
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
layout(rgba32f, binding = lightImage) writeonly restrict uniform image2D kept;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (at.x < view.size.x && at.y < view.rows.y) imageStore(kept, at, imageLoad(sums, at));
}

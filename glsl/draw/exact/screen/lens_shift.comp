// Shows each pixel of a view through four lens points of its own near the view's point (lens_shift.glsl). What is out of
// focus then shows fine grain instead of the edges of all views. One invocation handles one pixel.
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
layout(rgba32f, binding = lightImage) writeonly restrict uniform image2D shifted;
#include "draw/exact/screen/lens_read.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= view.size.x || at.y >= view.size.y) return;
  precise vec4 light = vec4(0.0f);
  for (int i = 0; i < pointsAPixel; ++i)
    light = light + 0.25f * min(imageLoad(sums, shiftedFrom(at, pointsAPixel * number + i, lens, view.size)), 6e4f);
  imageStore(shifted, at, light);
}

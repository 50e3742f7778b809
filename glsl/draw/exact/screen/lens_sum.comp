// Averages the light of several views: moments of the shutter and points of the lens. Each dispatch adds the light in
// `sums` to the total; a last one (MEAN) writes the mean to `sums`. LENS: each pixel looks through points of its own near
// the view's point of the lens (lens_shift.glsl), so that what is out of focus shows fine grain instead of the edges of
// all views. One invocation handles one pixel.
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = lightImage) restrict uniform image2D total;
#ifdef MEAN
layout(rgba32f, binding = sumImage) writeonly restrict uniform image2D sums;
uniform float share;  // 1 / number of views
#else
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
uniform int number;  // index of the view
#ifdef LENS
layout(r32f, binding = nearnessImage) readonly restrict uniform image2D nearness;
uniform vec3 lens;  // x and y: shift of a point at infinity, and its decrease per nearness (pixels per radius of the
                    // lens); z: side of the square around the view's point (radii)

float nearnessAt(ivec2 at) {
  return imageLoad(nearness, at).x;
}
#include "draw/exact/screen/lens_shift.glsl"
#endif
#endif

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= view.size.x || at.y >= view.size.y) return;
#ifdef MEAN
  precise vec4 mean = imageLoad(total, at) * share;
  imageStore(sums, at, mean);
#else
#ifdef LENS
  precise vec4 light = vec4(0.0);
  for (int i = 0; i < pointsAPixel; ++i)
    light = light + 0.25f * min(imageLoad(sums, shiftedFrom(at, pointsAPixel * number + i, lens, view.size)), 6e4f);
#else
  vec4 light = min(imageLoad(sums, at), 6e4f);
#endif
  precise vec4 sum = light + (number == 0 ? vec4(0.0) : imageLoad(total, at));
  imageStore(total, at, sum);
#endif
}

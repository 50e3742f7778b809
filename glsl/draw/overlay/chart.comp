// Draws a chart over the finished picture. One invocation draws one pixel.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/overlay/chart_inputs.glsl"
#include "draw/overlay/chart_columns.glsl"
#include "draw/overlay/chart_shading.glsl"
#include "draw/overlay/pixel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8, binding = targetImage) uniform restrict image2D target;
uniform ivec4 part;  // bounds of the chart's panel in the picture, in pixels: left, top, right, bottom

void main() {
  ivec2 at = part.xy + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, part.zw))) return;
  precise vec2 middle = vec2(at) + 0.5;
  imageStore(target, at, storedBytes(laidOver(bytesOf(imageLoad(target, at)), chartPixel(middle))));
}

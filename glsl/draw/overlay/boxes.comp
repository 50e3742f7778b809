// Fills the rectangles of letters and lines over the finished picture. Each rectangle has two texels: its bounds in
// whole pixels (left, top, right, bottom) and its encoded colour. The rectangles of one dispatch do not overlap unless
// they have the same colour, so their order does not matter. One invocation fills one rectangle.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/bindings.glsl"
#include "draw/overlay/pixel.glsl"
layout(local_size_x = 64) in;
layout(binding = boxUnit) uniform samplerBuffer boxes;
layout(rgba8, binding = targetImage) writeonly uniform restrict image2D target;
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  ivec4 box = ivec4(texelFetch(boxes, 2 * (first + i)));
  vec4 color = storedBytes(bytesOf(texelFetch(boxes, 2 * (first + i) + 1)));
  for (int y = box.y; y < box.w; ++y)
    for (int x = box.x; x < box.z; ++x) imageStore(target, ivec2(x, y), color);
}

// Draws a field of cells as a compute kernel, behind the light of the scene. OVER: draws over the finished picture
// instead. OPAQUE: the picture does not show through. One invocation draws ROWS vertically adjacent pixels.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/overlay/field_inputs.glsl"
#include "draw/overlay/field_view.glsl"
#include "draw/overlay/field_values.glsl"
#include "draw/screen/film.glsl"
#include "draw/overlay/field_shading.glsl"
#include "draw/overlay/pixel.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
#ifdef OPAQUE
layout(rgba8, binding = targetImage) writeonly uniform restrict image2D target;
#elif defined OVER
layout(rgba8, binding = targetImage) uniform restrict image2D target;
#else
layout(rgba32f, binding = targetImage) uniform restrict image2D target;
#endif
uniform ivec4 part;     // bounds of the field in the picture, in pixels from the top left: left, top, right, bottom
ivec4 part_ = once(part);
uniform int lastRow;    // index of the target's last row if row 0 of the target is the bottom row; otherwise -1
int lastRow_ = once(lastRow);

void put(ivec2 at) {
  ivec2 texel = ivec2(at.x, lastRow_ < 0 ? at.y : lastRow_ - at.y);
#ifdef OVER
#ifdef OPAQUE
  const vec4 below = vec4(0.0, 0.0, 0.0, 255.0);
#else
  vec4 below = bytesOf(imageLoad(target, texel));
#endif
  imageStore(target, texel, storedBytes(laidOver(below, fieldPixel(at))));
#else
  imageStore(target, texel, laidBehind(imageLoad(target, texel), fieldPixel(at)));
#endif
}

void main() {
  ivec2 first = part_.xy + ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (all(lessThan(at, part_.zw))) put(at);
  }
}

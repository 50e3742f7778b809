// Extent of a pixel of the ground on a shadow map. Ground seen at a grazing angle may show more of the map in a pixel
// than the shadow filter reads, so shadow edges would be steps. PIXEL_EXTENT: the taps of the filter are spread over the
// pixel. The ground is longest along one side of the pixel, so the other side is ignored.
#ifndef EXACT_PIXEL_EXTENT
#define EXACT_PIXEL_EXTENT
#include "common/exact.glsl"

// Vector (m) along which the lit point moves from pixel to pixel.
vec3 pixelAlong = vec3(0);

// Returns the part of a pixel over which to spread the taps of a filter of `radius` texels: none if the filter is as
// wide as the pixel. `along`: extent of the pixel in texels. Limits the extent to `most` texels. A box of width w
// texels has the variance of the filter if w^2 = 3 radius^2 + 2.
float spreadOver(vec2 along, float radius, float most) {
  precise float length2 = along.x * along.x + along.y * along.y;
  precise float filter2 = 3.0f * (radius * radius) + 2.0f;
  float per = exactReciprocal(max(length2, filter2));
  precise float beyond = 1.0f - filter2 * per;
  precise float limit = (most * most) * per;
  return min(beyond, limit);
}

// Returns the extent of a pixel along the ground for a point at `depth` on a ray. Grazing angles limit it.
vec3 groundExtent(vec3 direction, float depth) {
#ifdef PARALLEL
  const float scale = 1.0f;
#else
  float scale = depth;
#endif
  vec3 step_ = abs(view.rayDown.y) >= abs(view.rayAcross.y) ? vec3(view.rayDown) : vec3(view.rayAcross);
  float steep = direction.y;
  float per = exactReciprocal(abs(steep) >= 0.02f ? steep : steep < 0.0f ? -0.02f : 0.02f);
  precise float turns = step_.y * per;
  precise vec2 along = scale * (step_.xz - direction.xz * turns);
  return vec3(along.x, 0.0f, along.y);
}
#endif

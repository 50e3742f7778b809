// Projection of scene points to the picture: x and y in pixels times depth to the right and down, z depth (m);
// PARALLEL: pixels and depth. The including file declares `view`. Compiles as GLSL and as C++.
#ifndef EXACT_CORNER_PLACE
#define EXACT_CORNER_PLACE
#include "common/exact.glsl"

FUNCTION vec3 onPicture(vec3 p) {
  precise vec3 from = p - vec3(view.eye);
  vec3 at = vec3(exactDot(from, vec3(view.across)), exactDot(from, vec3(view.down)), exactDot(from, vec3(view.forward)));
#ifdef PARALLEL
  precise vec2 middle = 0.5f * vec2(view.size);
  precise vec2 pixel = vec2(at.x, at.y) + middle;
  at = vec3(pixel, at.z);
#endif
  return at;
}

// Converts a projected point to the rasterizer's form. PARALLEL: returns the projection from a virtual eye point with
// the depth for which near plane / depth equals nearOf() of draw/exact/depth.glsl. The mapping is a projective map of
// space that keeps planes flat and positions on the picture fixed. Points behind the depth range have no such depth: z
// is -1.
FUNCTION vec3 rasterPlace(vec3 at) {
#ifdef PARALLEL
  precise float near = 1.0f - (at.z - view.near) * view.forward.w;
  precise float depth = view.near * exactReciprocal(max(near, 1e-3f));
  precise vec2 scaled = vec2(at.x, at.y) * depth;
  return vec3(scaled, near < 1e-3f ? -1.0f : depth);
#else
  return at;
#endif
}
#endif

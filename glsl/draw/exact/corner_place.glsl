// Where a place of the scene lies on the picture: pixels times depth to the right and down, and depth (m); PARALLEL: pixels and depth.
// Whoever includes it has `view`. Compiles as GLSL and as C++.
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

// As the rasterizer has corners. PARALLEL: as if seen from a point, at a depth that makes nearest plane / depth what draw/exact/depth.glsl
// says: a projective map of space, under which planes stay planes and what lies on the picture stays where it is. Beyond the span, where
// that has no depth, corners are lost: their third number is none.
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

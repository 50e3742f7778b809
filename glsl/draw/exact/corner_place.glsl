// Projects scene points to the picture. x and y: pixels to the right and down, times depth; z: depth (m). PARALLEL: x
// and y are pixels. The including file declares `view`. Compiles as GLSL and as C++.
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

// Converts a projected point to the form that the rasterizer needs. PARALLEL: returns the perspective projection from a
// virtual eye point, with the depth for which near plane / depth equals nearOf() of draw/exact/depth.glsl. The mapping
// is a projective map of space that keeps planes flat and does not change positions in the picture. For points behind
// the depth range, where this depth does not exist, z is -1.
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

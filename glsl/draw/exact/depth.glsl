// Conversion of depth to nearness. Nearness is affine in the pixel position and 1 at the near plane. In perspective
// views it is near plane / depth. PARALLEL: it is 1 - (depth - near plane) / span. The including file declares `view`.
// Compiles as GLSL and as C++.
#ifndef EXACT_DEPTH
#define EXACT_DEPTH
#include "common/exact.glsl"

#ifdef PARALLEL
// Returns the nearness of a depth. The result is 0 at the far end of the depth range and beyond.
FUNCTION float nearOf(float depth) {
  precise float near = 1.0f - (depth - view.near) * view.forward.w;
  return max(near, 0.0f);
}
FUNCTION vec3 directionOf(vec3 ray) {
  return vec3(view.forward);
}
// Returns the vector (m) from the eye to the point at `depth` on the ray.
FUNCTION vec3 alongRay(vec3 ray, float depth) {
  precise vec3 along = ray + vec3(view.forward) * depth;
  return along;
}
#else
FUNCTION float nearOf(float depth) {
  precise float near = view.near * exactReciprocal(max(depth, 1e-6f));
  return near;
}
FUNCTION vec3 directionOf(vec3 ray) {
  return ray;
}
FUNCTION vec3 alongRay(vec3 ray, float depth) {
  precise vec3 along = ray * depth;
  return along;
}
#endif
#endif

// What lies at a depth, and how near that is: affine on the picture, 1 at the nearest plane. Along rays from the eye that is nearest plane /
// depth; PARALLEL ones: 1 - (depth - nearest plane) / span. Whoever includes it has `view`. Compiles as GLSL and as C++.
#ifndef EXACT_DEPTH
#define EXACT_DEPTH
#include "common/exact.glsl"

#ifdef PARALLEL
// More than 0, as keys have to be; 0 from where on nothing is seen.
FUNCTION float nearOf(float depth) {
  precise float near = 1.0f - (depth - view.near) * view.forward.w;
  return max(near, 0.0f);
}
FUNCTION vec3 directionOf(vec3 ray) {
  return vec3(view.forward);
}
// From the eye (m), without what is at depth 0.
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

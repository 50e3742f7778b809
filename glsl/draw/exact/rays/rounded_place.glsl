// Moves a point of a flat triangle to the curved surface that the corners' normals describe, so that shadow rays from a
// smooth-shaded surface do not hit its own facets (Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021).
// The normals must be on the viewer's side. Compiles as GLSL and as C++.
#ifndef EXACT_ROUNDED_PLACE
#define EXACT_ROUNDED_PLACE
#include "common/exact.glsl"

FUNCTION vec3 fromTangent(vec3 p, vec3 corner, vec3 n) {
  precise vec3 from = p - corner;
  float above = min(exactDot(from, n), 0.0f);
  precise vec3 moved = n * -above;
  return moved;
}
FUNCTION vec3 roundedPlace(vec3 p, vec3 a, vec3 b, vec3 c, vec3 na, vec3 nb, vec3 nc, vec3 weight) {
  precise vec3 q = p + fromTangent(p, a, na) * weight.x + fromTangent(p, b, nb) * weight.y + fromTangent(p, c, nc) * weight.z;
  return q;
}
#endif

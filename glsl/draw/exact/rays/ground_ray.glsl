// Intersects rays with the ground plane.
#ifndef EXACT_GROUND_RAY
#define EXACT_GROUND_RAY
#include "draw/surface/ground_alpha.glsl"

vec3 placeAlong(vec3 origin, vec3 along, float t) {
  precise vec3 p = origin + along * t;
  return p;
}

// Returns the distance along the ray (m), or -1 if the ray does not hit the ground.
float groundAlong(vec3 origin, vec3 along) {
  precise float down = frame.groundHeight - origin.y;
  bool towards = down < 0.0f ? along.y < -1e-6f : along.y > 1e-6f;
  precise float t = down * exactReciprocal(towards ? along.y : 1.0f);
  precise vec2 aside = origin.xz + along.xz * t - frame.target.xz;
  return towards && max(abs(aside.x), abs(aside.y)) <= frame.groundReach ? t : -1.0f;
}
#endif

// Intersects the ray through a picture position (pixels) with the ground plane. Compiles as GLSL and as C++.
#ifndef EXACT_GROUND_PLANE
#define EXACT_GROUND_PLANE
#include "common/exact.glsl"
#include "draw/exact/depth.glsl"

FUNCTION vec3 rayThrough(vec2 place) {
  precise vec3 ray = vec3(view.ray) + vec3(view.rayAcross) * place.x + vec3(view.rayDown) * place.y;
  return ray;
}

// Returns the depth (m) of the intersection, or -1 if the ray does not hit the ground square.
FUNCTION float groundDepth(vec3 ray) {
#ifdef PARALLEL
  precise float down = frame.groundHeight - (view.eye.y + ray.y);
  float steep = view.forward.y;
  bool towards = down < 0.0f ? steep < -1e-6f : steep > 1e-6f;
  precise float depth = down * exactReciprocal(towards ? steep : 1.0f);
  precise float x = view.eye.x + ray.x + view.forward.x * depth - frame.target.x;
  precise float z = view.eye.z + ray.z + view.forward.z * depth - frame.target.z;
  bool within = max(abs(x), abs(z)) <= frame.groundReach;
  return towards && within ? depth : -1.0f;
#else
  precise float down = frame.groundHeight - view.eye.y;
  bool towards = down < 0.0f ? ray.y < -1e-6f : ray.y > 1e-6f;
  float perDown = exactReciprocal(towards ? ray.y : 1.0f);
  precise float depth = down * perDown;
  precise float x = view.eye.x + ray.x * depth - frame.target.x;
  precise float z = view.eye.z + ray.z * depth - frame.target.z;
  bool within = max(abs(x), abs(z)) <= frame.groundReach;
  return towards && within ? depth : -1.0f;
#endif
}

FUNCTION vec3 placeOnRay(vec3 ray, float depth) {
  precise vec3 p = vec3(view.eye) + alongRay(ray, depth);
  return p;
}
#endif

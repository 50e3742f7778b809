// How near the ground is in a half pixel's middle, as keys have it, 0 where there is none; and what of that is 1 / depth (1/m), or with
// PARALLEL rays how many metres before what is never seen.
#include "draw/exact/ground_plane.glsl"
float perNear = exactReciprocal(view.near);

float groundNearness(ivec2 at) {
  float depth = groundDepth(rayThrough(vec2(2 * at + 1)));
  float ground = nearOf(depth);
  return depth >= view.near && ground >= view.nearOverFar ? ground : 0.0f;
}

float nearnessPerMetre(float near) {
#ifdef PARALLEL
  precise float perMetre = near * exactReciprocal(view.forward.w);
#else
  precise float perMetre = near * perNear;
#endif
  return perMetre;
}

// Returns the nearness of the ground at a picture position (pixels) or at the centre of a half-resolution pixel, or 0
// without ground. nearnessPerMetre()
// converts a nearness to 1 / depth (1/m) or, in orthographic views, to the distance (m) from the far end of the depth
// range.
#include "draw/exact/ground_plane.glsl"
float perNear = exactReciprocal(view.near);

float groundNearnessAt(vec2 place) {
  float depth = groundDepth(rayThrough(place));
  float ground = nearOf(depth);
  return depth >= view.near && ground >= view.nearOverFar ? ground : 0.0f;
}

float groundNearness(ivec2 at) {
  return groundNearnessAt(vec2(2 * at + 1));
}

float nearnessPerMetre(float near) {
#ifdef PARALLEL
  precise float perMetre = near * exactReciprocal(view.forward.w);
#else
  precise float perMetre = near * perNear;
#endif
  return perMetre;
}

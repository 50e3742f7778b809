// Pictures at half resolution. A half pixel (i, j) is the block of 2x2 pixels whose first pixel is (2 i, 2 j). Nearness
// is 1 / depth (1/m), or 0 for empty half pixels; for points of a plane, it is affine in the picture position. Compiles
// as GLSL and as C++.
#ifndef EXACT_HALF_PIXELS
#define EXACT_HALF_PIXELS
#include "common/exact.glsl"

// Returns the difference of nearness for a depth difference of `part` times the distance. PARALLEL: nearness is in
// metres, and the distance is replaced by 1.37 times the picture's height, the distance at which a view of 40 degrees
// has the same height. The including file declares `view`.
FUNCTION float partOf(float here, float part) {
#ifdef PARALLEL
  precise float height = float(view.size.y) * exactSqrt(exactDot(vec3(view.rayDown), vec3(view.rayDown)));
  precise float maximum = part * 1.37f * height;
#else
  precise float maximum = part * here;
#endif
  return maximum;
}

// Returns the change of nearness per half pixel to the right or downwards, from a half pixel and its two neighbours. If
// the surface is smooth and convex towards the eye, the result is the mean of the two differences. Otherwise it is the
// smaller difference, which does not cross an edge. A plane with this slope is never behind a point of a convex or flat
// surface, so the surface does not occlude itself.
FUNCTION float slopeBetween(float before, float here, float behind) {
  precise float to = here - before;
  precise float from = behind - here;
  precise float mean = 0.5f * (to + from);
  precise float bend = from - to;
  float maximum = partOf(here, 0.01f);
  float lesser = abs(to) < abs(from) ? to : from;
  return bend < 0.0f && bend > -maximum ? mean : lesser;
}
#endif

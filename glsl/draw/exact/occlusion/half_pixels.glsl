// Pictures at half size. Half pixel (i, j) covers the four pixels from (2 i, 2 j) on. Nearness is 1 / depth (1/m),
// which is affine on the picture of a plane; 0 without content. Compiles as GLSL and as C++.
#ifndef EXACT_HALF_PIXELS
#define EXACT_HALF_PIXELS
#include "common/exact.glsl"

// Returns the nearness difference that corresponds to the fraction `part` of the distance. PARALLEL: nearness is in
// metres, and the distance is replaced by 1.37 times the picture's height, the distance from which a view of 40 degrees
// would be as wide. The including file declares `view`.
FUNCTION float partOf(float here, float part) {
#ifdef PARALLEL
  precise float height = float(view.size.y) * exactSqrt(exactDot(vec3(view.rayDown), vec3(view.rayDown)));
  precise float most = part * 1.37f * height;
#else
  precise float most = part * here;
#endif
  return most;
}

// Returns the change of nearness per half pixel to the right or downwards, from a half pixel and its two neighbours. If
// the surface is smooth and convex towards the eye, it is the mean of the two differences; else it is the smaller
// difference, which does not cross an edge. The plane of this slope never lies behind a point of a convex or flat
// surface, so such surfaces do not occlude themselves.
FUNCTION float slopeBetween(float before, float here, float behind) {
  precise float to = here - before;
  precise float from = behind - here;
  precise float mean = 0.5f * (to + from);
  precise float bend = from - to;
  float most = partOf(here, 0.01f);
  float lesser = abs(to) < abs(from) ? to : from;
  return bend < 0.0f && bend > -most ? mean : lesser;
}
#endif

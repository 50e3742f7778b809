// Pictures of half the size: half pixel (i, j) is the four pixels from (2 i, 2 j) on. Nearness is 1 / depth (1/m), which is affine
// on the picture of a plane; 0 where nothing is. Compiles as GLSL and as C++.
#ifndef EXACT_HALF_PIXELS
#define EXACT_HALF_PIXELS
#include "common/exact.glsl"

// What of nearness is a part of the distance: with PARALLEL rays it is in metres, and what is seen as wide from that far away at 40 degrees
// counts as the distance: 1.37 times the picture's height. Whoever includes it has `view`.
FUNCTION float partOf(float here, float part) {
#ifdef PARALLEL
  precise float height = float(view.size.y) * exactSqrt(exactDot(vec3(view.rayDown), vec3(view.rayDown)));
  precise float most = part * 1.37f * height;
#else
  precise float most = part * here;
#endif
  return most;
}

// What a half pixel to the right, or downwards, adds to nearness, of that of one and of both its neighbours: the mean of the two
// differences where the surface is smooth and bulges towards the eye, else the lesser, which leads over no edge. Of what is convex
// nothing lies before the plane that this makes, nor of what is flat.
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

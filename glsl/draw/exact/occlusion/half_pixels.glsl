// Pictures of half the size: half pixel (i, j) is the four pixels from (2 i, 2 j) on. Nearness is 1 / depth (1/m), which is affine
// on the picture of a plane; 0 where nothing is. Compiles as GLSL and as C++.
#ifndef EXACT_HALF_PIXELS
#define EXACT_HALF_PIXELS
#include "common/exact.glsl"

// What a half pixel to the right, or downwards, adds to nearness, of that of one and of both its neighbours: the mean of the two
// differences where the surface is smooth and bulges towards the eye, else the lesser, which leads over no edge. Of what is convex
// nothing lies before the plane that this makes, nor of what is flat.
FUNCTION float slopeBetween(float before, float here, float behind) {
  precise float to = here - before;
  precise float from = behind - here;
  precise float mean = 0.5f * (to + from);
  precise float bend = from - to;
  precise float most = 0.01f * here;
  float lesser = abs(to) < abs(from) ? to : from;
  return bend < 0.0f && bend > -most ? mean : lesser;
}
#endif

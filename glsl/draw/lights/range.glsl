// A light's end. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Share of a light that is left at a squared distance (m^2) from it, by 1 / range^2: (1 - (d / range)^4)^2, which is as
// good as all of it near by and goes to nothing evenly (Karis 2013, as above); all where there is no range.
FUNCTION float rangeShare(float distance2, float perRange2) {
  ROUNDED float part = distance2 * perRange2;
  ROUNDED float left = 1.0f - part * part;
  float kept = max(left, 0.0f);
  ROUNDED float share = kept * kept;
  return share;
}

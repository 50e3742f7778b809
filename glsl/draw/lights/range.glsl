// Falloff of a light with a limited range. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Returns the fraction (1 - (d / range)^4)^2 of a light at the squared distance `distance2` = d^2 (m^2); `perRange2` =
// 1 / range^2. The fraction is nearly 1 close to the light and falls smoothly to 0 at the range (Karis, "Real shading
// in Unreal Engine 4", SIGGRAPH 2013). For a light without a range, perRange2 is 0 and the fraction is 1.
FUNCTION float rangeShare(float distance2, float perRange2) {
  ROUNDED float part = distance2 * perRange2;
  ROUNDED float left = 1.0f - part * part;
  float kept = max(left, 0.0f);
  ROUNDED float share = kept * kept;
  return share;
}

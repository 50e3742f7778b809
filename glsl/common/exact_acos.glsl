// Arc cosine with the same bits on every driver. Compiles as GLSL and, through common/cpp.hpp, as C++.
#ifndef EXACT_ACOS
#define EXACT_ACOS
#include "common/exact.glsl"

// Returns acos(x) for |x| <= 1 with an error below 1e-6. For x >= 0 it is sqrt(1 - x) times a polynomial of degree 7
// (Abramowitz and Stegun, 4.4.46); for x < 0 it is pi - acos(-x).
FUNCTION float exactAcos(float x) {
  precise float a = abs(x);
  precise float q = ((a * -1.2624911e-3f + 6.6700901e-3f) * a - 1.70881256e-2f) * a + 3.08918810e-2f;
  q = (((q * a - 5.01743046e-2f) * a + 8.89789874e-2f) * a - 0.2145988016f) * a + 1.5707963050f;
  precise float less = 1.0f - a;
  precise float angle = exactSqrt(max(less, 0.0f)) * q;
  precise float beyond = 3.14159265f - angle;
  return x < 0.0f ? beyond : angle;
}
#endif

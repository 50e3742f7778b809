// Arithmetic with the same bits on every driver. Compiles as GLSL and, through common/cpp.hpp, as C++.
// Only operations that IEEE 754 pins down are used (add, subtract, multiply, integers, floor), each
// rounded on its own by `precise`; divisions and roots are Newton iterations from an integer start.
// Literals carry an f: in C++ a bare 0.5 would be a double.
#ifndef FUNCTION
#define FUNCTION
#endif
#ifdef FAST_NUMERICS
#define precise
#endif

// Magnitudes below 1e-30 become zero: drivers disagree on subnormal numbers.
FUNCTION float exactFlush(float x) {
  return abs(x) < 1e-30f ? 0.0f : x;
}

// 1/sqrt(x) for x >= 1e-30, relative error below 3e-7. y' = y (3/2 - x y^2 / 2), three times.
// For x = 0 the result is large but finite.
FUNCTION float exactInverseSqrt(float x) {
#ifdef FAST_NUMERICS
  return inversesqrt(max(x, 1e-30f));
#else
  precise float half_ = 0.5f * x;
  precise float y = intBitsToFloat(0x5f375a86 - (floatBitsToInt(x) >> 1));
  precise float t = half_ * y;
  t = t * y;
  t = 1.5f - t;
  y = y * t;
  t = half_ * y;
  t = t * y;
  t = 1.5f - t;
  y = y * t;
  t = half_ * y;
  t = t * y;
  t = 1.5f - t;
  y = y * t;
  return y;
#endif
}

// sqrt(x) for x >= 0; zero below 1e-30.
FUNCTION float exactSqrt(float x) {
  precise float root = x * exactInverseSqrt(x);
  return x < 1e-30f ? 0.0f : root;
}

// 1/x for 1e-30 <= |x| <= 1e30, relative error below 3e-7. y' = y (2 - x y), three times.
FUNCTION float exactReciprocal(float x) {
#ifdef FAST_NUMERICS
  return 1.0f / x;
#else
  precise float a = abs(x);
  precise float y = intBitsToFloat(0x7ef311c7 - floatBitsToInt(a));
  precise float t = a * y;
  t = 2.0f - t;
  y = y * t;
  t = a * y;
  t = 2.0f - t;
  y = y * t;
  t = a * y;
  t = 2.0f - t;
  y = y * t;
  return x < 0.0f ? -y : y;
#endif
}

// sin(x) for |x| <= 1e4: x - 2 pi n in three parts (Cody and Waite), folded into [-pi/2, pi/2], then the
// odd Taylor polynomial of degree 11 (error below 6e-8 there).
FUNCTION float exactSin(float x) {
  precise float turns = x * 0.15915494f;
  turns = turns + 0.5f;
  precise float n = floor(turns);
  precise float p = n * 6.28125f;
  precise float r = x - p;
  p = n * 1.9350052e-3f;
  r = r - p;
  p = n * 3.0199159e-7f;
  r = r - p;
  precise float folded = 3.14159265f - r;
  r = r > 1.57079633f ? folded : r;
  folded = -3.14159265f - r;
  r = r < -1.57079633f ? folded : r;
  precise float s = r * r;
  precise float q = s * -2.5052108e-8f;
  q = q + 2.7557319e-6f;
  q = q * s;
  q = q - 1.9841270e-4f;
  q = q * s;
  q = q + 8.3333333e-3f;
  q = q * s;
  q = q - 0.16666667f;
  q = q * s;
  q = q * r;
  q = q + r;
  return q;
}

FUNCTION float exactCos(float x) {
  precise float shifted = x + 1.57079633f;
  return exactSin(shifted);
}

// exp(x), zero below -69 and held at exp(69) above 69. x = n ln 2 + r, |r| <= ln2/2, Taylor of degree 7.
FUNCTION float exactExp(float x) {
  precise float held = min(max(x, -69.0f), 69.0f);
  precise float n = held * 1.44269504f;
  n = n + 0.5f;
  n = floor(n);
  precise float p = n * 0.693359375f;
  precise float r = held - p;
  p = n * -2.12194440e-4f;
  r = r - p;
  precise float q = r * 1.9841270e-4f;
  q = q + 1.3888889e-3f;
  q = q * r;
  q = q + 8.3333333e-3f;
  q = q * r;
  q = q + 4.1666667e-2f;
  q = q * r;
  q = q + 0.16666667f;
  q = q * r;
  q = q + 0.5f;
  q = q * r;
  q = q + 1.0f;
  q = q * r;
  q = q + 1.0f;
  precise float scaled = q * intBitsToFloat((int(n) + 127) << 23);
  return x < -69.0f ? 0.0f : scaled;
}

FUNCTION float exactDot(vec3 a, vec3 b) {
  precise float x = a.x * b.x;
  precise float y = a.y * b.y;
  precise float z = a.z * b.z;
  precise float sum = x + y;
  sum = sum + z;
  return sum;
}

FUNCTION vec3 exactCross(vec3 a, vec3 b) {
  precise vec3 p = vec3(a.y * b.z, a.z * b.x, a.x * b.y);
  precise vec3 q = vec3(a.z * b.y, a.x * b.z, a.y * b.x);
  precise vec3 c = p - q;
  return c;
}

// Arithmetic with the same bits on every driver. Compiles as GLSL and, through common/cpp.hpp, as C++. The functions
// use only operations that IEEE 754 defines exactly (add, subtract, multiply, floor, integer operations); `precise`
// makes the compiler round each operation separately. Divisions and roots are Newton iterations from an integer start
// value. Float literals need the suffix f, because in C++ a number without it, such as 0.5, is a double.
#ifndef EXACT_ARITHMETIC
#define EXACT_ARITHMETIC
#ifdef FAST_NUMERICS
#define precise
#endif

// Returns x, or zero if |x| < 1e-30, because drivers disagree on subnormal numbers.
FUNCTION float exactFlush(float x) {
  return abs(x) < 1e-30f ? 0.0f : x;
}

// Returns true if x is neither infinite nor NaN. Tests the bits, because compilers may assume that comparisons never
// involve NaN.
FUNCTION bool isNumber(float x) {
  return (floatBitsToInt(x) & 0x7f800000) != 0x7f800000;
}

// Returns 1/sqrt(x) for x >= 1e-30 with a relative error below 3e-7. Uses three Newton steps y' = y (3/2 - x y^2 / 2).
// The result for x = 0 is large but finite. Works on each component of a vector.
#ifdef FAST_NUMERICS
#define EXACT_INVERSE_SQRT(T) \
  T exactInverseSqrt(T x) { return inversesqrt(max(x, T(1e-30f))); }
#else
#define EXACT_INVERSE_SQRT(T)                                            \
  FUNCTION T exactInverseSqrt(T x) {                                     \
    precise T half_ = 0.5f * x;                                          \
    precise T y = intBitsToFloat(0x5f375a86 - (floatBitsToInt(x) >> 1)); \
    y = y * (1.5f - half_ * y * y);                                      \
    y = y * (1.5f - half_ * y * y);                                      \
    y = y * (1.5f - half_ * y * y);                                      \
    return y;                                                            \
  }
#endif
EXACT_INVERSE_SQRT(float)

// Returns sqrt(x) for x >= 0; the result is zero for x below 1e-30.
FUNCTION float exactSqrt(float x) {
  precise float root = x * exactInverseSqrt(x);
  return x < 1e-30f ? 0.0f : root;
}

// Returns 1/x for 1e-30 <= |x| <= 1e30 with a relative error below 3e-7. Uses three Newton steps y' = y (2 - x y).
FUNCTION float exactReciprocal(float x) {
#ifdef FAST_NUMERICS
  return 1.0f / x;
#else
  precise float a = abs(x);
  precise float y = intBitsToFloat(0x7ef311c7 - floatBitsToInt(a));
  y = y * (2.0f - a * y);
  y = y * (2.0f - a * y);
  y = y * (2.0f - a * y);
  return x < 0.0f ? -y : y;
#endif
}

// Returns sin(x) for |x| <= 1e4. Subtracts 2 pi n in three parts (Cody and Waite), folds the remainder into [-pi/2,
// pi/2] and evaluates the odd Taylor polynomial of degree 11 (error below 6e-8 in that interval).
FUNCTION float exactSin(float x) {
  precise float turns = x * 0.15915494f + 0.5f;
  precise float n = floor(turns);
  precise float r = x - n * 6.28125f - n * 1.9350052e-3f - n * 3.0199159e-7f;
  int bits = floatBitsToInt(r), magnitude = bits & 0x7fffffff;
  precise float folded = intBitsToFloat((bits ^ magnitude) | 0x40490fdb) - r;  // pi or -pi
  r = magnitude > 0x3fc90fdb ? folded : r;                                     // pi / 2
  precise float s = r * r;
  precise float q = ((s * -2.5052108e-8f + 2.7557319e-6f) * s - 1.9841270e-4f) * s + 8.3333333e-3f;
  q = (q * s - 0.16666667f) * s * r + r;
  return q;
}

FUNCTION float exactCos(float x) {
  precise float shifted = x + 1.57079633f;
  return exactSin(shifted);
}

// Returns exp(x); the result is zero for x < -69, and exp(69) for x > 69. Splits x = n ln 2 + r with |r| <= ln2/2, and
// evaluates the Taylor polynomial of degree 7 in r.
FUNCTION float exactExp(float x) {
#if defined FAST_NUMERICS && defined EXACT_PICTURE
  return x < -69.0f ? 0.0f : exp(min(x, 69.0f));  // inexact: rounding depends on the driver
#else
  precise float held = min(max(x, -69.0f), 69.0f);
  precise float doublings = held * 1.44269504f + 0.5f;
  precise float n = floor(doublings);
  precise float r = held - n * 0.693359375f - n * -2.12194440e-4f;
  precise float q = ((r * 1.9841270e-4f + 1.3888889e-3f) * r + 8.3333333e-3f) * r + 4.1666667e-2f;
  q = (((q * r + 0.16666667f) * r + 0.5f) * r + 1.0f) * r + 1.0f;
  q = q * intBitsToFloat((int(n) + 127) << 23);
  return x < -69.0f ? 0.0f : q;
#endif
}

// Returns log(x) for x >= 1e-30 with a relative error below 3e-7. Splits x = 2^n m with m between sqrt(1/2) and
// sqrt(2), and evaluates the polynomial of Cephes (logf.c) for log(1 + t) with t = m - 1.
FUNCTION float exactLog(float x) {
#if defined FAST_NUMERICS && defined EXACT_PICTURE
  return log(x);  // inexact: rounding depends on the driver
#else
  int n = (floatBitsToInt(x) - 0x3f3504f3) >> 23;
  precise float t = intBitsToFloat(floatBitsToInt(x) - n * 8388608) - 1.0f;
  precise float q = ((t * 7.0376836292e-2f - 1.1514610310e-1f) * t + 1.1676998740e-1f) * t - 1.2420140846e-1f;
  q = ((q * t + 1.4249322787e-1f) * t - 1.6668057665e-1f) * t + 2.0000714765e-1f;
  q = (q * t - 2.4999993993e-1f) * t + 3.3333331174e-1f;
  precise float s = t * t;
  precise float low = q * t * s - float(n) * 2.12194440e-4f - 0.5f * s;
  precise float sum = float(n) * 0.693359375f + (t + low);
  return sum;
#endif
}

// Returns x^y for y >= 0 and results between exp(-69) and exp(69), with a relative error below 4e-7 (1 + |y log x|).
// The result is zero for x < 1e-30 and y > 0, and exp(0) for y = 0.
FUNCTION float exactPow(float x, float y) {
  precise float power = y * exactLog(max(x, 1e-30f));
  return x < 1e-30f && y > 0.0f ? 0.0f : exactExp(power);
}

FUNCTION float exactDot(vec3 a, vec3 b) {
  precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

FUNCTION float exactDot(vec4 a, vec4 b) {
  precise float sum = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
  return sum;
}

FUNCTION vec3 exactCross(vec3 a, vec3 b) {
  precise vec3 c =
      vec3(a.y * b.z, a.z * b.x, a.x * b.y) - vec3(a.z * b.y, a.x * b.z, a.y * b.x);
  return c;
}

FUNCTION vec3 exactMix(vec3 a, vec3 b, float t) {
  precise vec3 mixed = a + (b - a) * t;
  return mixed;
}
#endif

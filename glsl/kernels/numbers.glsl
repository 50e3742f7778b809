// Arithmetic for users' kernels (products, quotients, roots, conversions) with the same bits on every driver. Each
// function replaces one SPIR-V operation (src/kernels/exact/calls.cpp). Parameters are const, because glslang then
// passes them by value. `mix` with a bool selects without a branch. NaN and infinities are detected by their bits,
// because compilers may assume that comparisons never involve NaN. Magnitudes are also compared as integers, because
// NVIDIA's compiler converts the result of a comparison of floats before it uses it for a selection.
//
// The sign of a zero is undefined, because NVIDIA's compiler computes 0.0 + x as x, which is wrong for x = -0.0. No function
// depends on it, and stored zeros become positive (kernels/run).
//
// Subnormal numbers count as zero: drivers that flush them to zero after rounding (sim/kernels/arithmetic) need no code for that.
// For all others, the library is compiled with CAREFUL, which flushes in software.
#include "common/exact.glsl"

const int xTiny = 0x0da24260;      // bits of 1e-30
const int xNormal = 0x00800000;    // bits of the smallest normal number, 2^-126
const int xInfinity = 0x7f800000;  // bits of infinity; larger magnitudes are NaN

int xMagnitude(const float x) {
  return floatBitsToInt(x) & 0x7fffffff;
}
bool xIsNan(const float x) {
  return xMagnitude(x) > xInfinity;
}
bool xIsInf(const float x) {
  return xMagnitude(x) == xInfinity;
}
float xNan() {
  return intBitsToFloat(0x7fc00000);
}

// Replaces magnitudes below 1e-30 by zero.
float xFlush(const float x) {
  return mix(x, 0.0, xMagnitude(x) < xTiny);
}

// Replaces subnormal numbers by zero with the same sign.
float xFlushSubnormal(const float x) {
  return mix(x, intBitsToFloat(floatBitsToInt(x) & int(0x80000000)), xMagnitude(x) < xNormal);
}

// Returns a b, with a software flush. Without CAREFUL, only products with a tiny constant call it, because compilers
// that compute a constant result do not flush it.
#ifdef CAREFUL
// A product that rounds up to 2^-126 is flushed if it is smaller with an unlimited exponent. The smaller factor times
// 2^64 shows that.
float xMul(const float a, const float b) {
  float c = xFlushSubnormal(a), d = xFlushSubnormal(b);
  bool first = xMagnitude(c) < xMagnitude(d);
  precise float p = c * d;
  precise float scaled = mix(d, c, first) * 18446744073709551616.0;
  scaled = scaled * mix(c, d, first);
  return mix(p, intBitsToFloat(floatBitsToInt(p) & int(0x80000000)), xMagnitude(scaled) < 0x20800000);  // 2^-62
}
float xAdd(const float a, const float b) {
  precise float sum = xFlushSubnormal(a) + xFlushSubnormal(b);
  return xFlushSubnormal(sum);
}
float xSub(const float a, const float b) {
  return xAdd(a, -b);
}
#else
float xMul(const float a, const float b) {
  precise float p = a * b;
  return xFlushSubnormal(p);
}
#endif
#define TWICE(F) \
  vec2 F(const vec2 a, const vec2 b) { return vec2(F(a.x, b.x), F(a.y, b.y)); } \
  vec3 F(const vec3 a, const vec3 b) { return vec3(F(a.x, b.x), F(a.y, b.y), F(a.z, b.z)); } \
  vec4 F(const vec4 a, const vec4 b) { return vec4(F(a.x, b.x), F(a.y, b.y), F(a.z, b.z), F(a.w, b.w)); }
TWICE(xMul)

// Products and sums within the library.
#ifdef CAREFUL
TWICE(xAdd) TWICE(xSub)
#define TIMES(a, b) xMul(a, b)
#define PLUS(a, b) xAdd(a, b)
#define MINUS(a, b) xSub(a, b)
#else
#define TIMES(a, b) ((a) * (b))
#define PLUS(a, b) ((a) + (b))
#define MINUS(a, b) ((a) - (b))
#endif

// Returns c ? b : a. As a vector, NVIDIA's compiler selects without a branch, which halves the time of such a kernel.
float xPick(const float a, const float b, const bool c) {
  return mix(vec2(a), vec2(b), bvec2(c)).x;
}

// True if the driver's fma() rounds once and its 1 / x and inversesqrt() need a correction; false if its 1 / x and
// sqrt() are rounded correctly. text/glsl.cpp replaces this function by a macro, which the runtime sets.
bool xFused() {
#ifdef simreel_fused
  return simreel_fused;
#else
  return true;
#endif
}

// Returns 1 / b rounded to nearest: infinity for zero and subnormal b of either sign, zero for |b| above 2^126.
float xReciprocal(const float b) {
#ifdef CAREFUL
  // With b = m 2^e and integers M = m 2^23 and Y = 2^24 / m: a Newton iteration gives Y within two units, and the
  // remainder 2^47 - M Y corrects it.
  int bits = xMagnitude(b), e = (bits >> 23) - 127, M = (bits & 0x007fffff) | xNormal;
  float m = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
  precise float near = exactReciprocal(m) * 16777216.0;
  int Y = int(near);
  for (int i = 0; i < 3; ++i) {
    int rest = -(M * Y);
    Y += int(2 * rest > M) - int(2 * rest < -M);
  }
  precise float y = float(Y) * 5.96046448e-8;
  int made = floatBitsToInt(y) - (e << 23);
  made = mix(made, 0, e > 126 || (e == 126 && M != xNormal));
  made |= floatBitsToInt(b) & int(0x80000000);
  made = mix(made, xInfinity, bits < xNormal);
  return intBitsToFloat(mix(made, 0x7fc00000, bits > xInfinity));
#else
  precise float y = 1.0 / b;
  if (!xFused()) return mix(y, abs(y), xMagnitude(y) == xInfinity);
  precise float error = fma(-b, y, 1.0);  // NaN if b is zero or infinite
  precise float better = fma(y, error, y);
  return xPick(abs(y), better, xMagnitude(error) < 0x3f000000);  // 0.5
#endif
}

// Returns a times the rounded 1 / b. The relative error is below 1.8e-7; b counts as zero below 2^-126 and as infinite
// above 2^126, which is the range for which GLSL defines divisions.
float xDiv(const float a, const float b) {
  precise float q = TIMES(a, xReciprocal(b));
  return q;
}

// Returns sqrt(x) rounded to nearest: zero for |x| below 2^-100, and NaN for other negative x.
float xSqrt(const float x) {
  float root;
#ifdef CAREFUL
  // With x = m 4^k, 1 <= m < 4 and integers N = m 2^46 and R = sqrt(N): a Newton iteration gives R within two units,
  // and the remainder N - R R corrects it.
  int bits = xMagnitude(x), e = (bits >> 23) - 127, odd = e & 1;
  float m = intBitsToFloat((bits & 0x007fffff) | (0x3f800000 + (odd << 23)));
  precise float near = exactSqrt(m) * 8388608.0;
  int R = int(near), N = ((bits & 0x007fffff) | xNormal) << (23 + odd);
  for (int i = 0; i < 3; ++i) {
    int rest = N - R * R;
    R += int(rest > R) - int(rest <= -R);
  }
  root = intBitsToFloat((R & 0x007fffff) + (((e >> 1) + 127) << 23) + ((R >> 24) << 23));
  root = mix(root, xNan(), floatBitsToInt(x) < 0 || bits > xInfinity);
#else
  if (xFused()) {
    precise float y = inversesqrt(x);
    precise float near = x * y;
    precise float error = fma(-near, near, x);
    precise float half_ = 0.5 * y;
    root = fma(error, half_, near);
  } else {
    root = sqrt(x);
  }
#endif
  root = xPick(0.0, root, xMagnitude(x) >= 0x0d800000);  // 2^-100
  return xPick(root, x, floatBitsToInt(x) == xInfinity);
}

// Returns 1 / sqrt(x) from both rounded results: infinity for |x| below 2^-100, NaN for other
// negative x.
float xInverseSqrt(const float x) {
  return xReciprocal(xSqrt(x));
}

// xMod() returns a - b floor(a / b), with the sign of b. xRem() returns a - b trunc(a / b), with the sign of a. If
// rounding moves the quotient to another integer, the result is corrected so that its magnitude stays below |b|.
float xMod(const float a, const float b) {
  float q = floor(xDiv(a, b));
  precise float r = MINUS(a, TIMES(b, q));
  precise float more = PLUS(r, b), less = MINUS(r, b);
  r = mix(r, more, mix(r, -r, b < 0.0) < 0.0);
  return mix(r, less, mix(less, -less, b < 0.0) >= 0.0);
}
float xRem(const float a, const float b) {
  float c = intBitsToFloat(xMagnitude(b)), d = intBitsToFloat(xMagnitude(a));
  float r = xMod(d, c);
  return intBitsToFloat(floatBitsToInt(r) ^ (floatBitsToInt(a) & int(0x80000000)));
}
float xFract(const float x) {
  precise float r = MINUS(x, floor(x));
  return r;
}
float xFma(const float a, const float b, const float c) {
  precise float sum = PLUS(TIMES(a, b), c);
  return sum;
}
float xMix(const float a, const float b, const float t) {
  precise float d = MINUS(b, a);
  precise float sum = PLUS(a, TIMES(d, t));
  return sum;
}

// Returns an integer that orders numbers: -NaN, -infinity .. -0, +0 .. infinity, NaN.
int xOrder(const float x) {
  int bits = floatBitsToInt(x);
  return bits ^ ((bits >> 31) & 0x7fffffff);
}
// If one operand is NaN, min and max return the other operand. As unsigned integers, the keys of all NaN follow each
// other, so that a shift puts them above all numbers (min) or below (max).
float xMin(const float a, const float b) {
  return mix(a, b, uint(xOrder(b) - int(0x807fffff)) < uint(xOrder(a) - int(0x807fffff)));
}
float xMax(const float a, const float b) {
  return mix(a, b, uint(xOrder(a) - 0x7f800001) < uint(xOrder(b) - 0x7f800001));
}
float xClamp(const float x, const float low, const float high) {
  return xMin(xMax(x, low), high);
}
float xSaturate(const float x) {
  return xClamp(x, 0.0, 1.0);
}
float xStep(const float edge, const float x) {
  return mix(1.0, 0.0, x < edge);
}
float xSmoothstep(const float a, const float b, const float x) {
  precise float far = MINUS(x, a), whole = MINUS(b, a);
  float t = xClamp(xDiv(far, whole), 0.0, 1.0);
  precise float slope = 3.0 - 2.0 * t;
  precise float smoothed = TIMES(TIMES(t, t), slope);
  return smoothed;
}
float xSign(const float x) {
  float one = intBitsToFloat(0x3f800000 | (floatBitsToInt(x) & int(0x80000000)));
  return mix(one, 0.0, uint(xMagnitude(x) - 1) >= uint(xInfinity));
}
float xRound(const float x) {
  return roundEven(x);
}
float xRadians(const float x) {
  precise float angle = TIMES(x, 0.0174532925);
  return angle;
}
float xDegrees(const float x) {
  precise float angle = TIMES(x, 57.2957795);
  return angle;
}
float xLdexp(const float x, const int n) {
  int held = clamp(n, -252, 252), part = held >> 1;
  precise float r = TIMES(x, intBitsToFloat((part + 127) << 23));
  r = TIMES(r, intBitsToFloat((held - part + 127) << 23));
  return r;
}

// Converts with saturation: NaN becomes 0, and values out of range become the nearest limit.
int xToInt(const float x) {
  int i = int(mix(x, 0.0, xMagnitude(x) >= 0x4f000000));
  int end = 0x7fffffff ^ (floatBitsToInt(x) >> 31);
  return mix(mix(i, end, xMagnitude(x) >= 0x4f000000), 0, xIsNan(x));
}
uint xToUint(const float x) {
  uint i = uint(mix(x, 0.0, floatBitsToUint(x) >= 0x4f800000u));
  return mix(i, 0xffffffffu, uint(floatBitsToInt(x) - 0x4f800000) <= uint(xInfinity - 0x4f800000));
}

// Corrects a quotient and its remainder if the remainder is not below b.
uvec2 xCorrected(const uvec2 made, const uint b) {
  bool more = made.y >= b;
  return uvec2(made.x + uint(more), made.y - mix(0u, b, more));
}

// Returns the quotient and the remainder for b > 0. Software drivers divide integers one lane at a time, which takes
// about 25 cycles each, so the quotient comes from a product: with r = 2^32 / b from below, the high word of a r is at most 2
// less than a / b. The float s is below 2^32 / b by a factor of 1 - 2^-20, which is more than its error, and a Newton step in
// whole numbers, r + r (2^32 - b r) / 2^32, squares the error. Two corrections make the result exact.
uvec2 xDivided(const uint a, const uint b) {
  float whole = float(b);
  precise float y = intBitsToFloat(0x7ef311c7 - floatBitsToInt(whole));
  y = y * (2.0 - whole * y);
  y = y * (2.0 - whole * y);
  precise float s = y * 4294963200.0;
  uint r = uint(s);
  uint high, low;
  umulExtended(r, 0u - b * r, high, low);
  r += high;
  umulExtended(a, r, high, low);
  uvec2 made = xCorrected(uvec2(high, a - high * b), b);
  return xCorrected(made, b);
}

// Division by zero gives a result with all bits set, as in Direct3D. The lowest integer divided by -1 gives the lowest
// integer.
uint xUdiv(const uint a, const uint b) {
  uvec2 made = xDivided(a, mix(b, 1u, b == 0u));
  return mix(made.x, 0xffffffffu, b == 0u);
}
uint xUmod(const uint a, const uint b) {
  uvec2 made = xDivided(a, mix(b, 1u, b == 0u));
  return mix(made.y, 0xffffffffu, b == 0u);
}
int xSdiv(const int a, const int b) {
  uint q = xDivided(uint(abs(a)), mix(uint(abs(b)), 1u, b == 0)).x;
  return mix(mix(int(q), -int(q), (a ^ b) < 0), -1, b == 0);
}
// Return the remainders of integer divisions. xSrem() has the sign of a, xSmod() the sign of b.
int xSrem(const int a, const int b) {
  uint r = xDivided(uint(abs(a)), mix(uint(abs(b)), 1u, b == 0)).y;
  return mix(mix(int(r), -int(r), a < 0), -1, b == 0);
}
// For a constant b, with which drivers multiply and shift.
int xSremBy(const int a, const int b) {
  uint r = uint(abs(a)) % mix(uint(abs(b)), 1u, b == 0);
  return mix(mix(int(r), -int(r), a < 0), -1, b == 0);
}
int xSmod(const int a, const int b) {
  int r = xSrem(a, b);
  return mix(r, r + b, b != 0 && r != 0 && (r ^ b) < 0);
}

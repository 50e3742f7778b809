// Arithmetic for users' kernels (products, quotients, roots, conversions) with the same bits on every driver. Each
// function replaces one SPIR-V operation (src/kernels/exact/calls.cpp). Parameters are const, because glslang then
// passes them by value. `mix` with a bool selects without a branch. NaN and infinities are detected by their bits,
// because compilers may assume that comparisons never involve NaN. Magnitudes are also compared as integers, because
// NVIDIA's compiler converts the result of a comparison of floats before it uses it for a selection.
#include "common/exact.glsl"

const int xTiny = 0x0da24260;      // bits of 1e-30
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

// Replaces magnitudes below 1e-30 by zero, because drivers disagree on subnormal numbers.
float xFlush(const float x) {
  return mix(x, 0.0, xMagnitude(x) < xTiny);
}
vec2 xFlush(const vec2 x) {
  return mix(x, vec2(0.0), lessThan(floatBitsToInt(x) & 0x7fffffff, ivec2(xTiny)));
}
vec3 xFlush(const vec3 x) {
  return mix(x, vec3(0.0), lessThan(floatBitsToInt(x) & 0x7fffffff, ivec3(xTiny)));
}
vec4 xFlush(const vec4 x) {
  return mix(x, vec4(0.0), lessThan(floatBitsToInt(x) & 0x7fffffff, ivec4(xTiny)));
}

float xMul(const float a, const float b) {
  precise float p = a * b;
  return xFlush(p);
}
vec2 xMul(const vec2 a, const vec2 b) {
  precise vec2 p = a * b;
  return xFlush(p);
}
vec3 xMul(const vec3 a, const vec3 b) {
  precise vec3 p = a * b;
  return xFlush(p);
}
vec4 xMul(const vec4 a, const vec4 b) {
  precise vec4 p = a * b;
  return xFlush(p);
}

// Returns a / b with a relative error below 3e-7, as a times exactReciprocal(b). Zeros, infinities and NaN follow IEEE
// 754, but |b| below 1e-30 counts as zero. The Newton steps preserve the sign of b, and NaN.
float xDiv(const float a, const float b) {
  int m = xMagnitude(b);
  float scale = mix(1.0, 5.42101086e-20, m > 0x7149f2ca);  // 2^-64 if |b| > 1e30, because 1 / b could be subnormal
  precise float c = b * scale;
  precise float y = intBitsToFloat(0x7ef311c7 - floatBitsToInt(c));
  y = y * (2.0 - c * y);
  y = y * (2.0 - c * y);
  y = y * (2.0 - c * y);
  y = mix(y, 0.0, m == xInfinity);
  y = mix(y, intBitsToFloat(xInfinity | (floatBitsToInt(b) & int(0x80000000))), m < xTiny);
  precise float q = a * y;
  q = q * scale;
  return xFlush(q);
}

// Returns NaN for x <= -1e-30, `zero` for |x| < 1e-30, otherwise `root`.
float xRootEnds(const float x, const float root, const float zero) {
  float r = mix(root, zero, floatBitsToInt(x) < xTiny);
  return mix(r, xNan(), floatBitsToUint(x) >= 0x8da24260u);
}
// Returns 1 / sqrt(x), which is infinity for zero and NaN for negative x.
float xInverseSqrt(const float x) {
  float y = exactInverseSqrt(x);
  y = mix(y, 0.0, floatBitsToInt(x) == xInfinity);
  return xRootEnds(x, y, intBitsToFloat(xInfinity));
}
// The Newton steps turn infinity into -infinity.
float xSqrt(const float x) {
  precise float root = x * exactInverseSqrt(x);
  return xRootEnds(x, abs(root), 0.0);
}

// xMod() returns a - b floor(a / b), with the sign of b. xRem() returns a - b trunc(a / b), with the sign of a. If
// rounding moves the quotient to another integer, the result is corrected so that its magnitude stays below |b|.
float xMod(const float a, const float b) {
  float q = floor(xDiv(a, b));
  precise float r = a - xMul(b, q);
  precise float more = r + b, less = r - b;
  r = mix(r, more, mix(r, -r, b < 0.0) < 0.0);
  return mix(r, less, mix(less, -less, b < 0.0) >= 0.0);
}
float xRem(const float a, const float b) {
  float c = intBitsToFloat(xMagnitude(b)), d = intBitsToFloat(xMagnitude(a));
  float r = xMod(d, c);
  return intBitsToFloat(floatBitsToInt(r) ^ (floatBitsToInt(a) & int(0x80000000)));
}
float xFract(const float x) {
  precise float r = x - floor(x);
  return xFlush(r);
}
float xFma(const float a, const float b, const float c) {
  precise float sum = xMul(a, b) + c;
  return sum;
}
float xMix(const float a, const float b, const float t) {
  precise float d = b - a;
  precise float sum = a + xMul(d, t);
  return sum;
}

// Returns an integer key for min and max, for which -0 is below +0. If one operand is NaN, min and max return the other
// operand.
int xOrder(const float x) {
  int bits = floatBitsToInt(x);
  return bits ^ ((bits >> 31) & 0x7fffffff);
}
float xMin(const float a, const float b) {
  float least = mix(a, b, xOrder(b) < xOrder(a));
  return mix(mix(least, a, xIsNan(b)), b, xIsNan(a));
}
float xMax(const float a, const float b) {
  float greatest = mix(a, b, xOrder(a) < xOrder(b));
  return mix(mix(greatest, a, xIsNan(b)), b, xIsNan(a));
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
  precise float far = x - a, whole = b - a;
  float t = xClamp(xDiv(far, whole), 0.0, 1.0);
  precise float slope = 3.0 - 2.0 * t;
  return xMul(xMul(t, t), slope);
}
float xSign(const float x) {
  float one = intBitsToFloat(0x3f800000 | (floatBitsToInt(x) & int(0x80000000)));
  return mix(one, 0.0, uint(xMagnitude(x) - 1) >= uint(xInfinity));
}
float xRound(const float x) {
  return roundEven(x);
}
float xRadians(const float x) {
  return xMul(x, 0.0174532925);
}
float xDegrees(const float x) {
  return xMul(x, 57.2957795);
}
float xLdexp(const float x, const int n) {
  int held = clamp(n, -252, 252), part = held >> 1;
  precise float r = x * intBitsToFloat((part + 127) << 23);
  r = r * intBitsToFloat((held - part + 127) << 23);
  return xFlush(r);
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
// Remainders of integers: xSrem() has the sign of a, xSmod() the sign of b.
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

// Trigonometric and exponential functions for users' kernels, and their inverses. They use common/exact.glsl within its
// valid range and extend that range.
#include "kernels/numbers.glsl"
#include "common/exact_acos.glsl"

// Bits of 1 / (2 pi), 32 bits per word, after one word of zeros.
const uint xTurn[8] =
    uint[8](0u, 0x28be60dbu, 0x9391054au, 0x7f09d5f4u, 0x7d4d3770u, 0x36d8a566u, 0x4f10e410u, 0x7f9458eau);

uint xTurnBits(const uint at) {
  uint word = at >> 5, shift = at & 31u;
  return mix(xTurn[word], (xTurn[word] << shift) | (xTurn[word + 1u] >> ((32u - shift) & 31u)), shift != 0u);
}

// Reduces x modulo 2 pi to -pi .. pi, for any |x| above 1, with integer products of the relevant bits of 1 / (2 pi)
// (Payne and Hanek 1983). With x = m 2^e, the upper bits of the product are whole turns, and the next 32 bits are the
// fraction of a turn.
float xFarAngle(const float x) {
  int bits = xMagnitude(x);
  uint m = uint((bits & 0x007fffff) | 0x00800000);
  uint at = uint(clamp((bits >> 23) - 150 + 32, 0, 160));
  uint high, low, rest, carry;
  umulExtended(m, xTurnBits(at + 32u), high, low);
  rest = m * xTurnBits(at);
  rest += high;
  precise float angle = float(int(rest)) * 1.46291808e-9;  // 2 pi / 2^32
  return mix(angle, -angle, floatBitsToInt(x) < 0);
}

float xSin(const float x) {
  float near = x;
  if (xMagnitude(x) > 0x461c4000) near = xFarAngle(x);
  float s = exactSin(near);
  return mix(xFlush(s), xNan(), xMagnitude(x) >= xInfinity);
}
// Returns cos(x). exactCos() adds a quarter turn to its argument, and this sum loses precision for large values. Above
// 100, the angle is therefore reduced first.
float xCos(const float x) {
  float near = x;
  if (xMagnitude(x) > 0x42c80000) near = xFarAngle(x);
  float c = exactCos(near);
  return mix(xFlush(c), xNan(), xMagnitude(x) >= xInfinity);
}
float xTan(const float x) {
  return xDiv(xSin(x), xCos(x));
}

// Returns e^x. exactExp() is valid up to 69; for larger x, squares e^(x / 2).
float xExp(const float x) {
  precise float half_ = 0.5 * x;
  int bits = floatBitsToInt(x);
  bool far = bits > 0x428a0000;
  float e = exactExp(mix(x, half_, far));
  precise float square = e * e;
  e = mix(e, square, far);
  e = mix(e, intBitsToFloat(xInfinity), bits > 0x42b17218);  // bits of 88.7228394, above which e^x is infinite
  return mix(e, x, xIsNan(x));
}
// Returns 2^x as 2^n e^(r ln 2), where x = n + r with an integer n, so that the result is exact for integer x.
float xExp2(const float x) {
  float held = clamp(mix(x, 0.0, xIsNan(x)), -127.0, 129.0);
  precise float middle = held + 0.5;
  float n = floor(middle);
  precise float r = held - n;
  r = r * 0.69314718;
  precise float q = ((r * 1.9841270e-4 + 1.3888889e-3) * r + 8.3333333e-3) * r + 4.1666667e-2;
  q = (((q * r + 0.16666667) * r + 0.5) * r + 1.0) * r + 1.0;
  int whole = int(n);
  float e = xLdexp(q, whole);
  return mix(e, x, xIsNan(x));
}
float xLogEnds(const float inside, const float x) {
  int m = xMagnitude(x);
  float l = mix(inside, intBitsToFloat(int(0xff800000)), m < xTiny);
  l = mix(l, intBitsToFloat(xInfinity), m == xInfinity);
  return mix(mix(l, xNan(), floatBitsToUint(x) >= 0x8da24260u), xNan(), m > xInfinity);
}
float xLog(const float x) {
  float l = exactLog(intBitsToFloat(max(xMagnitude(x), xTiny)));
  return xLogEnds(xFlush(l), x);
}
// Returns the binary logarithm of x. Works like exactLog(), but adds the integer exponent last, so that powers of two
// are exact.
float xLog2(const float x) {
  int bits = max(xMagnitude(x), xTiny);
  int n = (bits - 0x3f3504f3) >> 23;
  precise float t = intBitsToFloat(bits - n * 8388608) - 1.0;
  precise float q = ((t * 7.0376836292e-2 - 1.1514610310e-1) * t + 1.1676998740e-1) * t - 1.2420140846e-1;
  q = ((q * t + 1.4249322787e-1) * t - 1.6668057665e-1) * t + 2.0000714765e-1;
  q = (q * t - 2.4999993993e-1) * t + 3.3333331174e-1;
  precise float s = t * t;
  precise float part = t + (q * t * s - 0.5 * s);
  part = part * 1.44269504;
  part = part + float(n);
  return xLogEnds(xFlush(part), x);
}
// Returns x^y. Works like exactPow(), but extends the range above e^69. Returns 1 for y = 0 and NaN for negative x.
float xPow(const float x, const float y) {
  float l = exactLog(intBitsToFloat(max(xMagnitude(x), xTiny)));
  precise float power = y * l;
  float p = xExp(power);
  int m = xMagnitude(x);
  p = mix(p, mix(intBitsToFloat(xInfinity), 0.0, y > 0.0), m < xTiny);
  p = mix(p, mix(0.0, intBitsToFloat(xInfinity), y > 0.0), m == xInfinity);
  p = mix(p, xNan(), floatBitsToUint(x) >= 0x8da24260u);
  p = mix(p, 1.0, y == 0.0);
  return mix(mix(p, xNan(), m > xInfinity), xNan(), xIsNan(y));
}

// Returns the arc tangent of x like atanf() of the Cephes library, with argument reduction in three ranges.
float xAtan(const float x) {
  float a = abs(x);
  bool far = xMagnitude(x) > 0x401a827a, middle = xMagnitude(x) > 0x3ed413cd;  // bits of 1 + sqrt(2) and of sqrt(2) - 1
  precise float less = a - 1.0, more = a + 1.0;
  float t = xDiv(mix(mix(a, less, middle), -1.0, far), mix(mix(1.0, more, middle), a, far));
  precise float z = t * t;
  precise float q = ((z * 8.05374449538e-2 - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1;
  q = q * z * t + t;
  q = q + mix(mix(0.0, 0.78539816, middle), 1.57079633, far);
  q = xFlush(q);
  return mix(mix(q, -q, floatBitsToInt(x) < 0), x, xIsNan(x));
}
// Returns atan2(y, x), or zero if both arguments are zero.
float xAtan2(const float y, const float x) {
  float a = xAtan(xDiv(y, x));
  float half_ = mix(3.14159265, -3.14159265, floatBitsToUint(y) > 0x80000000u);
  precise float behind = a + half_;
  a = mix(a, behind, x < 0.0);
  float quarter = mix(1.57079633, -1.57079633, floatBitsToInt(y) < 0);
  return mix(a, mix(quarter, 0.0, xMagnitude(y) < xTiny), xMagnitude(x) < xTiny);
}
float xAsin(const float x) {
  precise float c = 1.0 - TIMES(x, x);
  return mix(xAtan2(x, xSqrt(max(c, 0.0))), xNan(), xMagnitude(x) > 0x3f800000);
}
float xAcos(const float x) {
  float a = exactAcos(clamp(mix(x, 0.0, xIsNan(x)), -1.0, 1.0));
  return mix(xFlush(a), xNan(), xMagnitude(x) > 0x3f800000);
}

// Returns sinh(x), by a series near zero and from e^x for larger |x|.
float xSinh(const float x) {
  precise float s = x * x;
  precise float near = ((s * 1.9841270e-4 + 8.3333333e-3) * s + 0.16666667) * s;
  near = near * x + x;
  precise float far = xExp(x) - xExp(-x);
  far = far * 0.5;
  return xFlush(mix(far, near, xMagnitude(x) < 0x3f000000));
}
float xCosh(const float x) {
  precise float sum = xExp(x) + xExp(-x);
  sum = sum * 0.5;
  return sum;
}
float xTanh(const float x) {
  float held = clamp(mix(x, 0.0, xIsNan(x)), -10.0, 10.0);
  return mix(xDiv(xSinh(held), xCosh(held)), x, xIsNan(x));
}
float xAsinh(const float x) {
  float a = abs(x);
  precise float root = xSqrt(TIMES(a, a) + 1.0);
  precise float sum = a + root;
  float l = xLog(sum);
  return mix(l, -l, floatBitsToInt(x) < 0);
}
float xAcosh(const float x) {
  precise float square = TIMES(x, x) - 1.0;
  precise float sum = x + xSqrt(square);
  return mix(xLog(sum), xNan(), floatBitsToInt(x) < 0);
}
float xAtanh(const float x) {
  precise float more = 1.0 + x, less = 1.0 - x;
  precise float half_ = TIMES(0.5, xLog(xDiv(more, less)));
  return half_;
}

// Packing functions for users' kernels: half floats and normalized integers, rounded to nearest, ties to even.
#include "kernels/numbers.glsl"

uint xToHalf(const float x) {
  uint bits = floatBitsToUint(x), sign = bits > 0x80000000u ? 0x8000u : 0u;
  int m = int(bits & 0x7fffffffu);
  // normal half float: exponent reduced by 112, mantissa rounded to 10 bits
  uint rounded = uint(m) + 0xfffu + ((uint(m) >> 13) & 1u);
  uint normal = (rounded - 0x38000000u) >> 13;
  // subnormal half float: multiple of 2^-24
  int shift = clamp(126 - (m >> 23), 14, 31);
  uint whole = uint(m & 0x007fffff) | 0x00800000u;
  uint part = whole >> uint(shift), left = whole & ((1u << uint(shift)) - 1u), middle = 1u << uint(shift - 1);
  part += uint(left > middle || (left == middle && (part & 1u) == 1u));
  uint h = mix(normal, mix(part, 0u, m < 0x33000000), m < 0x38800000);
  h = mix(h, 0x7c00u, m >= 0x477ff000);
  return sign | mix(h, 0x7e00u, m > xInfinity);
}
float xFromHalf(const uint h) {
  uint m = h & 0x7fffu;
  precise float small = float(m) * 5.9604645e-8;
  float x = mix(uintBitsToFloat((m << 13) + 0x38000000u), small, m < 0x400u);
  x = mix(x, uintBitsToFloat(0x7f800000u | ((m & 0x3ffu) << 13)), m >= 0x7c00u);
  return uintBitsToFloat(floatBitsToUint(x) | ((h & 0x8000u) << 16));
}
uint xPackHalf2x16(const vec2 v) {
  return xToHalf(v.x) | (xToHalf(v.y) << 16);
}
vec2 xUnpackHalf2x16(const uint p) {
  return vec2(xFromHalf(p & 0xffffu), xFromHalf(p >> 16));
}

uint xFraction(const float x, const float low, const float scale, const uint mask) {
  precise float scaled = xClamp(mix(x, 0.0, xIsNan(x)), low, 1.0) * scale;
  return uint(int(roundEven(scaled))) & mask;
}
uint xPackUnorm4x8(const vec4 v) {
  return xFraction(v.x, 0.0, 255.0, 255u) | (xFraction(v.y, 0.0, 255.0, 255u) << 8) |
         (xFraction(v.z, 0.0, 255.0, 255u) << 16) | (xFraction(v.w, 0.0, 255.0, 255u) << 24);
}
uint xPackSnorm4x8(const vec4 v) {
  return xFraction(v.x, -1.0, 127.0, 255u) | (xFraction(v.y, -1.0, 127.0, 255u) << 8) |
         (xFraction(v.z, -1.0, 127.0, 255u) << 16) | (xFraction(v.w, -1.0, 127.0, 255u) << 24);
}
uint xPackUnorm2x16(const vec2 v) {
  return xFraction(v.x, 0.0, 65535.0, 65535u) | (xFraction(v.y, 0.0, 65535.0, 65535u) << 16);
}
uint xPackSnorm2x16(const vec2 v) {
  return xFraction(v.x, -1.0, 32767.0, 65535u) | (xFraction(v.y, -1.0, 32767.0, 65535u) << 16);
}
float xShare(const float whole, const float scale) {
  return xClamp(xDiv(whole, scale), -1.0, 1.0);
}
vec4 xUnpackUnorm4x8(const uint p) {
  return vec4(xShare(float(p & 255u), 255.0), xShare(float((p >> 8) & 255u), 255.0), xShare(float((p >> 16) & 255u), 255.0),
              xShare(float(p >> 24), 255.0));
}
vec4 xUnpackSnorm4x8(const uint p) {
  int i = int(p);
  return vec4(xShare(float((i << 24) >> 24), 127.0), xShare(float((i << 16) >> 24), 127.0), xShare(float((i << 8) >> 24), 127.0),
              xShare(float(i >> 24), 127.0));
}
vec2 xUnpackUnorm2x16(const uint p) {
  return vec2(xShare(float(p & 65535u), 65535.0), xShare(float(p >> 16), 65535.0));
}
vec2 xUnpackSnorm2x16(const uint p) {
  int i = int(p);
  return vec2(xShare(float((i << 16) >> 16), 32767.0), xShare(float(i >> 16), 32767.0));
}

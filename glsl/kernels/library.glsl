// Library functions of users' kernels, with the same bits on every driver. Vector functions work component by
// component; sums are evaluated from left to right.
#include "kernels/numbers.glsl"
#include "kernels/functions.glsl"
#include "kernels/packing.glsl"
#include "kernels/sampling.glsl"

// Defines overloads of F for vectors of length 2 to 4, with 1, 2 or 3 arguments. R is the prefix of the result type; A
// and B are prefixes of the argument types.
#define EACH_1(F, R, A) \
  R##2 F(const A##2 a) { return R##2(F(a.x), F(a.y)); } \
  R##3 F(const A##3 a) { return R##3(F(a.x), F(a.y), F(a.z)); } \
  R##4 F(const A##4 a) { return R##4(F(a.x), F(a.y), F(a.z), F(a.w)); }
#define EACH_2(F, R, A, B) \
  R##2 F(const A##2 a, const B##2 b) { return R##2(F(a.x, b.x), F(a.y, b.y)); } \
  R##3 F(const A##3 a, const B##3 b) { return R##3(F(a.x, b.x), F(a.y, b.y), F(a.z, b.z)); } \
  R##4 F(const A##4 a, const B##4 b) { return R##4(F(a.x, b.x), F(a.y, b.y), F(a.z, b.z), F(a.w, b.w)); }
#define EACH_3(F) \
  vec2 F(const vec2 a, const vec2 b, const vec2 c) { return vec2(F(a.x, b.x, c.x), F(a.y, b.y, c.y)); } \
  vec3 F(const vec3 a, const vec3 b, const vec3 c) { return vec3(F(a.x, b.x, c.x), F(a.y, b.y, c.y), F(a.z, b.z, c.z)); } \
  vec4 F(const vec4 a, const vec4 b, const vec4 c) { \
    return vec4(F(a.x, b.x, c.x), F(a.y, b.y, c.y), F(a.z, b.z, c.z), F(a.w, b.w, c.w)); \
  }
#define FLOATS(F) EACH_1(F, vec, vec)
#define PAIRS(F) EACH_2(F, vec, vec, vec)
PAIRS(xDiv) PAIRS(xMod) PAIRS(xRem) PAIRS(xMin) PAIRS(xMax) PAIRS(xStep) PAIRS(xPow) PAIRS(xAtan2)
FLOATS(xSqrt) FLOATS(xInverseSqrt) FLOATS(xFract) FLOATS(xSign) FLOATS(xRound) FLOATS(xRadians) FLOATS(xDegrees)
FLOATS(xSin) FLOATS(xCos) FLOATS(xTan) FLOATS(xExp) FLOATS(xExp2) FLOATS(xLog) FLOATS(xLog2) FLOATS(xAtan) FLOATS(xAsin)
FLOATS(xAcos) FLOATS(xSinh) FLOATS(xCosh) FLOATS(xTanh) FLOATS(xAsinh) FLOATS(xAcosh) FLOATS(xAtanh)
EACH_3(xFma) EACH_3(xMix) EACH_3(xClamp) EACH_3(xSmoothstep)
EACH_1(xToInt, ivec, vec) EACH_1(xToUint, uvec, vec) EACH_1(xIsNan, bvec, vec) EACH_1(xIsInf, bvec, vec)
EACH_2(xUdiv, uvec, uvec, uvec) EACH_2(xUmod, uvec, uvec, uvec) EACH_2(xSdiv, ivec, ivec, ivec)
EACH_2(xSrem, ivec, ivec, ivec) EACH_2(xSremBy, ivec, ivec, ivec) EACH_2(xSmod, ivec, ivec, ivec) EACH_2(xLdexp, vec, vec, ivec)

float xDot(const float a, const float b) {
  precise float p = TIMES(a, b);
  return p;
}
float xDot(const vec2 a, const vec2 b) {
  precise float sum = PLUS(TIMES(a.x, b.x), TIMES(a.y, b.y));
  return sum;
}
float xDot(const vec3 a, const vec3 b) {
  precise float sum = PLUS(PLUS(TIMES(a.x, b.x), TIMES(a.y, b.y)), TIMES(a.z, b.z));
  return sum;
}
float xDot(const vec4 a, const vec4 b) {
  precise float sum = PLUS(PLUS(PLUS(TIMES(a.x, b.x), TIMES(a.y, b.y)), TIMES(a.z, b.z)), TIMES(a.w, b.w));
  return sum;
}
vec3 xCross(const vec3 a, const vec3 b) {
  precise vec3 c = MINUS(TIMES(a.yzx, b.zxy), TIMES(a.zxy, b.yzx));
  return c;
}

float xLength(const float v) {
  return abs(v);
}
float xDistance(const float a, const float b) {
  precise float d = MINUS(a, b);
  return abs(d);
}
float xNormalize(const float v) {
  return xSign(v);
}
// Normalizing a zero vector gives zero. For a vector shorter than 1e-15, the result is shorter than 1.
#define GEOMETRY(T) \
  float xLength(const T v) { return xSqrt(xDot(v, v)); } \
  float xDistance(const T a, const T b) { precise T d = MINUS(a, b); return xLength(d); } \
  T xNormalize(const T v) { \
    int square = max(floatBitsToInt(xDot(v, v)), xTiny); \
    precise T unit = TIMES(v, T(xInverseSqrt(intBitsToFloat(square)))); \
    return unit; \
  }
GEOMETRY(vec2) GEOMETRY(vec3) GEOMETRY(vec4)
#define REFLECTION(T) \
  T xReflect(const T i, const T n) { \
    precise float twice = TIMES(2.0, xDot(n, i)); \
    precise T r = MINUS(i, TIMES(T(twice), n)); \
    return r; \
  } \
  T xRefract(const T i, const T n, const float eta) { \
    float d = xDot(n, i); \
    precise float sine = MINUS(1.0, TIMES(d, d)); \
    precise float k = MINUS(1.0, TIMES(TIMES(eta, eta), sine)); \
    precise float along = PLUS(TIMES(eta, d), xSqrt(xMax(k, 0.0))); \
    precise T r = MINUS(TIMES(T(eta), i), TIMES(T(along), n)); \
    return k < 0.0 ? T(0.0) : r; \
  } \
  T xFaceForward(const T n, const T i, const T reference) { return xDot(reference, i) < 0.0 ? n : -n; }
REFLECTION(float) REFLECTION(vec2) REFLECTION(vec3) REFLECTION(vec4)

// Matrices with C columns and R rows, stored column by column.
#define MATRIX(M, R, C) \
  R xTimes(const M m, const vec##C v) { \
    precise R sum = PLUS(TIMES(m[0], R(v[0])), TIMES(m[1], R(v[1]))); \
    for (int i = 2; i < C; ++i) sum = PLUS(sum, TIMES(m[i], R(v[i]))); \
    return sum; \
  } \
  vec##C xTimes(const R v, const M m) { \
    vec##C sums; \
    for (int i = 0; i < C; ++i) sums[i] = xDot(v, m[i]); \
    return sums; \
  } \
  M xTimes(const M m, const float s) { \
    M scaled; \
    for (int i = 0; i < C; ++i) scaled[i] = TIMES(m[i], R(s)); \
    return scaled; \
  } \
  M xOuter(const R a, const vec##C b) { \
    M product; \
    for (int i = 0; i < C; ++i) product[i] = TIMES(a, R(b[i])); \
    return product; \
  }
MATRIX(mat2x2, vec2, 2) MATRIX(mat2x3, vec3, 2) MATRIX(mat2x4, vec4, 2)
MATRIX(mat3x2, vec2, 3) MATRIX(mat3x3, vec3, 3) MATRIX(mat3x4, vec4, 3)
MATRIX(mat4x2, vec2, 4) MATRIX(mat4x3, vec3, 4) MATRIX(mat4x4, vec4, 4)
#define PRODUCT(A, B, M, N) \
  M xTimes(const A a, const B b) { \
    M product; \
    for (int i = 0; i < N; ++i) product[i] = xTimes(a, b[i]); \
    return product; \
  }
#define PRODUCTS(R, C) \
  PRODUCT(mat##C##x##R, mat2x##C, mat2x##R, 2) \
  PRODUCT(mat##C##x##R, mat3x##C, mat3x##R, 3) PRODUCT(mat##C##x##R, mat4x##C, mat4x##R, 4)
PRODUCTS(2, 2) PRODUCTS(2, 3) PRODUCTS(2, 4) PRODUCTS(3, 2) PRODUCTS(3, 3) PRODUCTS(3, 4) PRODUCTS(4, 2) PRODUCTS(4, 3)
PRODUCTS(4, 4)

float xDeterminant(const mat2 m) {
  precise float d = MINUS(TIMES(m[0].x, m[1].y), TIMES(m[1].x, m[0].y));
  return d;
}
float xDeterminant(const mat3 m) {
  return xDot(m[0], xCross(m[1], m[2]));
}
// Returns the determinant of m without column c and row r.
float xMinor(const mat4 m, const int c, const int r) {
  mat3 rest;
  for (int i = 0; i < 3; ++i) {
    vec4 column = m[i + int(i >= c)];
    rest[i] = vec3(column[int(0 >= r)], column[1 + int(1 >= r)], column[2 + int(2 >= r)]);
  }
  return xDeterminant(rest);
}
float xDeterminant(const mat4 m) {
  vec4 minors = vec4(xMinor(m, 0, 0), -xMinor(m, 0, 1), xMinor(m, 0, 2), -xMinor(m, 0, 3));
  return xDot(m[0], minors);
}
mat2 xInverse(const mat2 m) {
  float d = xDeterminant(m);
  return mat2(xDiv(m[1].y, d), xDiv(-m[0].y, d), xDiv(-m[1].x, d), xDiv(m[0].x, d));
}
mat3 xInverse(const mat3 m) {
  vec3 d = vec3(xDeterminant(m));
  return transpose(mat3(xDiv(xCross(m[1], m[2]), d), xDiv(xCross(m[2], m[0]), d), xDiv(xCross(m[0], m[1]), d)));
}
mat4 xInverse(const mat4 m) {
  float d = xDeterminant(m);
  mat4 inverted;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) {
      float share = xDiv(xMinor(m, c, r), d);
      inverted[r][c] = (c + r) % 2 == 0 ? share : -share;
    }
  return inverted;
}

layout(local_size_x = 1) in;
void main() {}

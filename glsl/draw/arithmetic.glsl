// Arithmetic of shading for both rasterizers. If EXACT_PICTURE is defined, results have the same bits on every driver,
// and assignments to ROUNDED variables round each operation separately. Otherwise, the driver's built-in functions are
// used. Vectors passed to unitOf() must be longer than 1e-15. Compiles as GLSL and as C++.
#ifndef DRAW_ARITHMETIC
#define DRAW_ARITHMETIC
#ifdef EXACT_PICTURE
#include "common/exact.glsl"
#define ROUNDED precise

FUNCTION float dotted(vec3 a, vec3 b) {
  return exactDot(a, b);
}
FUNCTION vec3 crossed(vec3 a, vec3 b) {
  return exactCross(a, b);
}
FUNCTION float inverseRoot(float x) {
  return exactInverseSqrt(x);
}
FUNCTION float root(float x) {
  return exactSqrt(x);
}
FUNCTION float inverse(float x) {
  return exactReciprocal(x);
}
FUNCTION float powerOfTwo(float x) {
  precise float natural = x * 0.69314718f;
  return exactExp(natural);
}
FUNCTION float logarithmOfTwo(float x) {
  precise float logarithm = exactLog(x) * 1.44269504f;
  return logarithm;
}
#else
#define ROUNDED

float dotted(vec3 a, vec3 b) {
  return dot(a, b);
}
vec3 crossed(vec3 a, vec3 b) {
  return cross(a, b);
}
float inverseRoot(float x) {
  return inversesqrt(x);
}
float root(float x) {
  return sqrt(x);
}
float inverse(float x) {
  return 1.0 / x;
}
float powerOfTwo(float x) {
  return exp2(x);
}
float logarithmOfTwo(float x) {
  return log2(x);
}
#endif

FUNCTION vec3 unitOf(vec3 v) {
  ROUNDED vec3 u = v * inverseRoot(dotted(v, v));
  return u;
}
FUNCTION vec3 blend(vec3 a, vec3 b, float t) {
  ROUNDED vec3 blended = a + (b - a) * t;
  return blended;
}
// Returns the smoothstep polynomial 3 t^2 - 2 t^3.
FUNCTION float smoothed(float t) {
  ROUNDED float s = t * t * (3.0f - 2.0f * t);
  return s;
}
#endif

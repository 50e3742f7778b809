// Rounds a value to half-float precision before the shader stores it in a half-float texel, so that the driver does not
// round it. Magnitudes below the smallest normal half float become zero.
#include "common/exact.glsl"

vec2 asHalf(vec2 v) {
  vec2 held = unpackHalf2x16(packHalf2x16(clamp(v, -65504.0, 65504.0)));
  return vec2(abs(held.x) < 6.2e-5 ? 0.0 : held.x, abs(held.y) < 6.2e-5 ? 0.0 : held.y);
}
vec4 asHalf(vec4 v) {
  return vec4(asHalf(v.xy), asHalf(v.zw));
}

// Height gradients along a surface, from slopes in texture space. Compiles as GLSL and as C++.
#ifndef DRAW_RISE
#define DRAW_RISE
#include "draw/arithmetic.glsl"

// Returns the gradient of the height q along a surface, per cell. `slope` holds the slopes along u and v. `across` and
// `up` are the changes of the position per pixel to the right and up. `right` and `above` are the same changes of the
// uv (Mikkelsen, "Surface gradient-based bump mapping framework", JCGT 9(3), 2020). Works for mirrored uvs and for both
// faces.
FUNCTION vec3 riseByUv(vec2 slope, vec3 normal, vec3 across, vec3 up, vec2 right, vec2 above) {
  vec3 first = crossed(up, normal), second = crossed(normal, across);
  float turned = dotted(across, first) < 0.0f ? -1.0f : 1.0f;
  ROUNDED vec3 u = first * right.x + second * above.x;
  ROUNDED vec3 v = first * right.y + second * above.y;
  ROUNDED vec3 alongU = u * inverseRoot(max(dotted(u, u), 1e-30f));
  ROUNDED vec3 alongV = v * inverseRoot(max(dotted(v, v), 1e-30f));
  ROUNDED vec3 rise = turned * (slope.x * alongU + slope.y * alongV);
  return rise;
}

// Returns the gradient in the surface's object space for a texture projected along the three axes (three_sides.glsl).
// x, y and z are the slopes in the three projections.
FUNCTION vec3 riseFromSides(vec3 weight, vec3 side, vec2 x, vec2 y, vec2 z) {
  ROUNDED vec3 rise = weight.x * vec3(0, -x.y, -side.x * x.x) + weight.y * vec3(y.x, 0, side.y * y.y) +
                      weight.z * vec3(side.z * z.x, -z.y, 0);
  return rise;
}
#endif

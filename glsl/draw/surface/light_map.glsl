// Transform into the sun's shadow map, written by shadow_fit.comp. Only vertex shaders and kernels need it: the
// coordinates are affine in space, so they can be interpolated.
#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;

// Returns the position of a world point in the shadow map. xy: 0 to 1 across the map; z: depth from the light.
vec3 shadowPlace(vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(exactDot(texelFetch(light, 0), q), exactDot(texelFetch(light, 1), q), exactDot(texelFetch(light, 2), q));
}
float shadowTexel() {
  return texelFetch(light, 3).x;
}
// Returns the size (m) of the box that the shadow map covers: two sides and the depth.
vec3 shadowExtent() {
  return texelFetch(light, 3).yyz;
}
// Returns an offset to the lit side of a surface. The shadow lookup adds this offset so that the surface does not
// shadow itself.
vec3 shadowLift(vec3 normal) {
  precise float side = 4.0 * exactDot(normal, frame.sunDirection.xyz);
  precise float step_ = clamp(side, -1.0, 1.0) * shadowTexel() * (0.5 + 0.5 * frame.shadowSoftness);
  precise vec3 lift = normal * step_;
  return lift;
}

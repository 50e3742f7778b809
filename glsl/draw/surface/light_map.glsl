// The light's map as shadow_fit.comp wrote it. Read by vertex shaders only: coordinates are affine in space,
// so they may be interpolated.
#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;

// Place of a world position in the shadow map: xy 0 to 1 over the map, z depth from the light.
vec3 shadowPlace(vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(exactDot(texelFetch(light, 0), q), exactDot(texelFetch(light, 1), q), exactDot(texelFetch(light, 2), q));
}
float shadowTexel() {
  return texelFetch(light, 3).x;
}
// What the map covers (m): two sides and the depth.
vec3 shadowExtent() {
  return texelFetch(light, 3).yyz;
}
// A step to the lit side of a surface: looked up there, it does not shade itself.
vec3 shadowLift(vec3 normal) {
  precise float side = 4.0 * exactDot(normal, frame.sunDirection.xyz);
  precise float step_ = clamp(side, -1.0, 1.0) * shadowTexel() * (0.5 + 0.5 * frame.shadowSoftness);
  precise vec3 lift = normal * step_;
  return lift;
}

// The light's map as shadow_fit.comp wrote it. Read by vertex shaders only: coordinates are affine in space,
// so they may be interpolated.
#include "draw/bindings.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;

// Place of a world position in the shadow map: xy 0 to 1 over the map, z depth from the light.
vec3 shadowPlace(vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(dot(texelFetch(light, 0), q), dot(texelFetch(light, 1), q), dot(texelFetch(light, 2), q));
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
  float side = clamp(4.0 * dot(normal, frame.sunDirection.xyz), -1.0, 1.0);
  return normal * (side * shadowTexel() * (0.5 + 0.5 * frame.shadowSoftness));
}

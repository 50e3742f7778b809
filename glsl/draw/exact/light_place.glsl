// Transform to the sun's shadow map in exact arithmetic (like draw/surface/light_map.glsl).
// draw/surface/shadow_fit.comp writes the transform.
#include "draw/bindings.glsl"
#include "common/exact.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;
// The shadow map's transform, read once per invocation instead of in each round of a loop.
vec4 lightAcross = texelFetch(light, 0), lightUp = texelFetch(light, 1), lightAway = texelFetch(light, 2);
vec4 lightSize = texelFetch(light, 3);

// Returns the position of a point in the shadow map. xy: 0 to 1 across the map; z: depth from the sun.
vec3 lightPlace(vec3 p) {
  precise float x = exactDot(lightAcross.xyz, p) + lightAcross.w;
  precise float y = exactDot(lightUp.xyz, p) + lightUp.w;
  precise float z = exactDot(lightAway.xyz, p) + lightAway.w;
  return vec3(x, y, z);
}
float lightTexel() {
  return lightSize.x;
}
// Returns the depth range of the sun's shadow map (m).
float lightDepth() {
  return lightSize.z;
}

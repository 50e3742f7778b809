// The sun's map as draw/surface/shadow_fit.comp places it (draw/surface/light_map.glsl), exactly.
#include "draw/bindings.glsl"
#include "common/exact.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;
// Once, not in each turn of a loop.
vec4 lightAcross = texelFetch(light, 0), lightUp = texelFetch(light, 1), lightAway = texelFetch(light, 2);
vec4 lightSize = texelFetch(light, 3);

// xy 0 to 1 over the map, z depth from the sun.
vec3 lightPlace(vec3 p) {
  precise float x = exactDot(lightAcross.xyz, p) + lightAcross.w;
  precise float y = exactDot(lightUp.xyz, p) + lightUp.w;
  precise float z = exactDot(lightAway.xyz, p) + lightAway.w;
  return vec3(x, y, z);
}
float lightTexel() {
  return lightSize.x;
}
// Of the map (m).
float lightDepth() {
  return lightSize.z;
}

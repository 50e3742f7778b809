// The sun's map as draw/surface/shadow_fit.comp places it (draw/surface/light_map.glsl), exactly.
#include "draw/bindings.glsl"
#include "common/exact.glsl"
layout(binding = lightUnit) uniform samplerBuffer light;

// xy 0 to 1 over the map, z depth from the sun.
vec3 lightPlace(vec3 p) {
  vec4 across = texelFetch(light, 0), up = texelFetch(light, 1), away = texelFetch(light, 2);
  precise float x = exactDot(across.xyz, p) + across.w;
  precise float y = exactDot(up.xyz, p) + up.w;
  precise float z = exactDot(away.xyz, p) + away.w;
  return vec3(x, y, z);
}
float lightTexel() {
  return texelFetch(light, 3).x;
}

// Vertices of a sim::Surface by number, world space. GRID: neighbours give the normal.
#include "draw/bindings.glsl"
layout(binding = positionUnit) uniform samplerBuffer positions;
uniform mat4 model;

#ifdef DEFORMED
#include "draw/surface/deformed_vertex.glsl"
#endif
vec3 worldPoint(int i) {
  vec3 p = texelFetch(positions, i).xyz;
#ifdef DEFORMED
  p = displaced(p);
#endif
  return (model * vec4(p, 1.0)).xyz;
}

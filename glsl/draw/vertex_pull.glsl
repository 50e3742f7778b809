// Vertices of a sim::Surface by number, world space. GRID: neighbours give the normal.
layout(binding = 0) uniform samplerBuffer positions;
uniform mat4 model;

vec3 worldPoint(int i) {
  return (model * vec4(texelFetch(positions, i).xyz, 1.0)).xyz;
}

// Reads vertices of a sim::Surface in world space, by index, in exact arithmetic. GRID: the vertices form a grid, from
// which normals are computed; otherwise normals are read. DEFORMED: vertices are displaced first
// (draw/surface/deformed_vertex.glsl).
#include "draw/bindings.glsl"
#include "common/exact.glsl"
#include "draw/surface/vertex_texel.glsl"
uniform mat4 model;
#ifdef GRID
uniform ivec2 grid;
#else
layout(binding = normalUnit) uniform samplerBuffer normals;
#endif
#ifdef DEFORMED
#include "draw/surface/deformed_vertex.glsl"
#endif

vec3 turnedByModel(vec3 v) {
  precise vec3 q = model[0].xyz * v.x + model[1].xyz * v.y + model[2].xyz * v.z;
  return q;
}

vec3 worldPlace(int i) {
  vec3 p = vertexPlace(i);
#ifdef DEFORMED
  p = displaced(p);
#endif
  precise vec3 q = turnedByModel(p) + model[3].xyz;
  return q;
}

// worldNormal() returns the normal of vertex i. The normal does not have unit length.
#ifdef GRID
// Uses central differences, or one-sided ones at the borders. The normal points to the same side as the normal of the
// triangles (a, a + width, a + 1).
vec3 worldNormal(int i) {
  int x = i % grid.x, y = i / grid.x;
  precise vec3 right = worldPlace(i + min(grid.x - 1 - x, 1)) - worldPlace(i - min(x, 1));
  precise vec3 down = worldPlace(i + grid.x * min(grid.y - 1 - y, 1)) - worldPlace(i - grid.x * min(y, 1));
  return exactCross(down, right);
}
#elif defined DEFORMED
// Computes the normal from the differences of four displaced points. Before the displacement, the points lie on both
// sides of the vertex along tangent and bitangent, at the distance rest.w (length of its shortest edge).
vec3 worldNormal(int i) {
  vec4 rest = texelFetch(positions, i);
  vec3 normal = texelFetch(normals, i).xyz;
  vec3 along = exactCross(normal, exactCross(abs(normal.x) < 0.7f ? vec3(1, 0, 0) : vec3(0, 0, 1), normal));
  precise vec3 tangent = along * exactInverseSqrt(exactDot(along, along));
  vec3 bitangent = exactCross(normal, tangent);
  precise vec3 aside = tangent * rest.w;
  precise vec3 above = bitangent * rest.w;
  precise vec3 right = rest.xyz + aside;
  precise vec3 left = rest.xyz - aside;
  precise vec3 up = rest.xyz + above;
  precise vec3 down = rest.xyz - above;
  precise vec3 first = displaced(right) - displaced(left);
  precise vec3 second = displaced(up) - displaced(down);
  return turnedByModel(exactCross(first, second));
}
#else
vec3 worldNormal(int i) {
  return turnedByModel(texelFetch(normals, i).xyz);
}
#endif

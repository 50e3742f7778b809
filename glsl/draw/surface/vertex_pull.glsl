// Fetches the vertices of a sim::Surface by index, in world space. GRID: computes normals from neighbouring vertices.
#include "common/exact.glsl"
#include "draw/bindings.glsl"
#include "draw/surface/vertex_texel.glsl"
uniform mat4 model;

#ifdef DEFORMED
#include "draw/surface/deformed_vertex.glsl"
#endif
vec3 worldPoint(int i) {
  vec3 p = vertexPlace(i);
#ifdef DEFORMED
  p = displaced(p);
#endif
  precise vec3 world = model[0].xyz * p.x + model[1].xyz * p.y + model[2].xyz * p.z + model[3].xyz;
  return world;
}

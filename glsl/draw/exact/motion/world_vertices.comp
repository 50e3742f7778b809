// Writes a surface's vertices and normals in world space, as input of the interpolation between frames. One invocation
// writes one vertex. GRID: the vertices form a grid, from which normals are computed; otherwise normals are read.
// DEFORMED: vertices are displaced first (draw/surface/deformed_vertex.glsl). PALETTE: also writes the palette index of
// each vertex.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/world_vertex.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = outVertexBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outNormalBinding) writeonly restrict buffer NormalBlock { vec4 directions[]; };
uniform int vertexCount;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= vertexCount) return;
  float color = 0.0f;
#ifdef PALETTE
  color = float(vertexColor(i));
#endif
  places[i] = vec4(worldPlace(i), color);
  directions[i] = vec4(worldNormal(i), 0.0f);
}

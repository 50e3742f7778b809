// Appends a surface to the joined surfaces: vertices in world space, triangles, and the owner word of each triangle
// (twice the index of the surface, plus 1 if both sides are visible). One invocation handles one vertex and one
// triangle. GRID, DEFORMED: as in draw/exact/triangles/world_vertex.glsl.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/world_vertex.glsl"
layout(local_size_x = 64) in;
layout(binding = indexUnit) uniform usamplerBuffer indices;
layout(std430, binding = outVertexBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outNormalBinding) writeonly restrict buffer NormalBlock { vec4 directions[]; };
layout(std430, binding = largeBinding) writeonly restrict buffer IndexBlock { uint joined[]; };
layout(std430, binding = counterBinding) writeonly restrict buffer OwnerBlock { uint owners[]; };
uniform int vertexCount;
uniform int firstVertex;
uniform int triangleCount;
uniform int firstTriangle;
uniform ivec2 rowOf;  // layout of a grid's indices; see `rowOf` in draw/exact/triangles/surface_triangle.glsl
uniform uint owner;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i < vertexCount) {
    places[firstVertex + i] = vec4(worldPlace(i), 1.0f);
    directions[firstVertex + i] = vec4(worldNormal(i), 0.0f);
  }
  if (i >= triangleCount) return;
  owners[firstTriangle + i] = owner;
  int row = rowOf.x > 0 ? i / rowOf.x : 0;
  int first = 3 * (i - row * rowOf.x), vertex = firstVertex + row * rowOf.y;
  for (int k = 0; k < 3; ++k) joined[3 * (firstTriangle + i) + k] = uint(vertex) + texelFetch(indices, first + k).x;
}

// Appends a surface to the merged mesh of shadow casters: vertices in world space, and triangles in any order. One
// invocation handles one vertex and one triangle. DEFORMED: as in draw/exact/triangles/world_vertex.glsl. COUNTED: the
// GPU has written the number of triangles to the draw arguments.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/world_vertex.glsl"
layout(local_size_x = 64) in;
layout(binding = indexUnit) uniform usamplerBuffer indices;
layout(std430, binding = outVertexBinding) writeonly restrict buffer VertexBlock { vec4 places[]; };
layout(std430, binding = largeBinding) writeonly restrict buffer IndexBlock { uint merged[]; };
layout(std430, binding = counterBinding) restrict buffer CountBlock { uint mergedCount; };
#ifdef COUNTED
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint drawArguments[]; };
#endif
uniform int vertexCount;
uniform int firstVertex;
uniform int triangleCount;
uniform ivec2 rowOf;  // layout of a grid's indices; see `rowOf` in draw/exact/triangles/surface_triangle.glsl

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i < vertexCount) places[firstVertex + i] = vec4(worldPlace(i), 1.0f);
#ifdef COUNTED
  int triangles = min(int(drawArguments[0] / 3u), triangleCount);
#else
  int triangles = triangleCount;
#endif
  if (i >= triangles) return;
  int at = int(atomicAdd(mergedCount, 3u));
  int row = rowOf.x > 0 ? i / rowOf.x : 0;
  int first = 3 * (i - row * rowOf.x), vertex = firstVertex + row * rowOf.y;
  for (int k = 0; k < 3; ++k) merged[at + k] = uint(vertex) + texelFetch(indices, first + k).x;
}

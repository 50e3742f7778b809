// Puts a surface's vertices in world space behind those of others, and its triangles, in any order, into a common list.
// Variants: DEFORMED, COUNTED.
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
uniform ivec2 rowOf;  // as draw/exact/triangles/surface_triangle.glsl has it

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

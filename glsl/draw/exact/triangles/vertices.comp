// Projects the vertices of one surface for the rasterizer: pixels to the right and down, times depth; depth (m); packed
// normal. Invalid vertices are marked (draw/exact/vertex.glsl). PARALLEL: as in draw/exact/corner_place.glsl. SUN_MAP:
// texels of the sun's shadow map; 1; nearness to the sun. One invocation handles one vertex. GRID, DEFORMED: as in
// draw/exact/triangles/world_vertex.glsl.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/world_vertex.glsl"
#include "draw/exact/vertex.glsl"
#ifdef SUN_MAP
#include "draw/exact/light_place.glsl"
uniform float mapTexels;
#else
#include "draw/exact/unit_vector.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/corner_place.glsl"
#endif
layout(local_size_x = 64) in;
layout(std430, binding = outVertexBinding) writeonly restrict buffer VertexBlock { uvec4 vertices[]; };
uniform int vertexCount;
uniform int firstVertex;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= vertexCount) return;
  vec3 p = worldPlace(i);
#ifdef SUN_MAP
  vec3 place = lightPlace(p);
  precise vec2 texel = place.xy * mapTexels;
  precise float near = 1.0f - place.z;
  vec3 at = vec3(texel, 1.0f);
  uint word = uint(floatBitsToInt(max(near, 0.0f)));
#else
  vec3 at = onPicture(p);
  uint word = packedUnit(worldNormal(i));
#endif
  bool found = isNumber(at.x) && isNumber(at.y) && isNumber(at.z);
  vertices[firstVertex + i] = found ? uvec4(floatBitsToUint(at), word) : uvec4(0u, 0u, 0u, lostVertex);
}

// Triangles of one surface, by number: its indices, and its vertices as vertices.comp left them.
#include "draw/exact/bindings.glsl"
#include "draw/exact/vertex.glsl"
layout(binding = vertexUnit) uniform usamplerBuffer vertices;
layout(binding = indexUnit) uniform usamplerBuffer indices;
uniform int firstVertex;
uniform int triangleCount;  // less than 0: as the GPU has written into the arguments of the surface's draw
uniform int firstIndex;
#ifdef COUNTED
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint drawArguments[]; };
int trianglesToDraw() {
  return int(drawArguments[0] / 3u);
}
#else
int trianglesToDraw() {
  return triangleCount;
}
#endif

ivec3 cornersOf(int triangle) {
  int i = 3 * triangle;
  return firstVertex + ivec3(texelFetch(indices, i).x, texelFetch(indices, i + 1).x, texelFetch(indices, i + 2).x);
}
vec3 placeOf(uvec4 vertex) {
  return uintBitsToFloat(vertex.xyz);
}

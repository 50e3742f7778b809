// Reads triangles of one surface by index: the vertex indices, and the vertices that vertices.comp wrote. LAMP_MAP:
// triangles of the merged mesh, whose vertices are projected here for each face. FACES: one dispatch handles several
// faces (draw/exact/view_block.glsl).
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/vertex.glsl"
#ifdef LAMP_MAP
#include "common/exact.glsl"
#include "draw/exact/view_block.glsl"
layout(binding = vertexUnit) uniform samplerBuffer places;

uvec4 vertexOf(int i) {
  precise vec3 from = texelFetch(places, i).xyz - view.eye.xyz;
  vec3 at = vec3(exactDot(from, view.across.xyz), exactDot(from, view.down.xyz), exactDot(from, view.forward.xyz));
  bool found = isNumber(at.x) && isNumber(at.y) && isNumber(at.z);
  return found ? uvec4(floatBitsToUint(at), 0u) : uvec4(0u, 0u, 0u, lostVertex);
}
#else
layout(binding = vertexUnit) uniform usamplerBuffer vertices;

uvec4 vertexOf(int i) {
  return texelFetch(vertices, i);
}
#endif
layout(binding = indexUnit) uniform usamplerBuffer indices;
uniform int firstVertex;
int firstVertex_ = once(firstVertex);
uniform int triangleCount;  // number of triangles; if negative, the GPU has written the number to the surface's draw
                            // arguments
#ifdef FACES
int firstIndex = 3 * face_ * triangleCount, list = face_;
#else
uniform int firstIndex;
#endif
#ifdef LAMP_MAP
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint listed[]; };
layout(binding = tileListUnit) uniform usamplerBuffer lists;
#ifndef FACES
uniform int list;  // index of the shadow map face's triangle list
#endif
int trianglesToDraw() {
  return int(listed[list]);
}
int triangleAt(int place) {
  return int(texelFetch(lists, list * triangleCount + place).x);
}
#elif defined COUNTED
layout(std430, binding = drawArgumentBinding) readonly restrict buffer DrawArgumentBlock { uint drawArguments[]; };
int trianglesToDraw() {
  return int(drawArguments[0] / 3u);
}
#else
int trianglesToDraw() {
  return triangleCount;
}
#endif

uniform ivec2 rowOf;  // for a grid that stores the indices of only one row, x: triangles per row, y: vertices per row;
                      // 0 if the indices of all triangles are stored
ivec2 rowOf_ = once(rowOf);

ivec3 cornersOf(int triangle) {
  ivec2 each = rowOf_;
  int row = each.x > 0 ? triangle / each.x : 0;
  int i = 3 * (triangle - row * each.x);
  return firstVertex_ + row * each.y + ivec3(texelFetch(indices, i).x, texelFetch(indices, i + 1).x, texelFetch(indices, i + 2).x);
}
vec3 placeOf(uvec4 vertex) {
  return uintBitsToFloat(vertex.xyz);
}
#ifdef PARALLEL
#include "draw/exact/view_block.glsl"
#include "draw/exact/corner_place.glsl"
// Returns the vertex position in the form that the rasterizer needs (draw/exact/corner_place.glsl).
vec3 drawnPlace(uvec4 vertex) {
  return rasterPlace(placeOf(vertex));
}
#else
vec3 drawnPlace(uvec4 vertex) {
  return placeOf(vertex);
}
#endif

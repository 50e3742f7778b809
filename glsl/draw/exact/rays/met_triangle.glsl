// Corners and material index (owner) of a triangle that a ray has hit.
#include "draw/exact/rays/looks.glsl"
layout(binding = solidUnit) uniform usamplerBuffer sortedSolids;
layout(binding = solidIdUnit) uniform usamplerBuffer solidIds;
#include "draw/exact/rays/solid_words.glsl"

ivec3 metCorners(int at) {
  int id = int(texelFetch(solidIds, at).x);
  return ivec3(int(texelFetch(corners, 3 * id).x), int(texelFetch(corners, 3 * id + 1).x), int(texelFetch(corners, 3 * id + 2).x));
}
vec3 metPlace(int at, int corner) {
  return uintBitsToFloat(texelFetch(sortedSolids, 3 * at + corner).xyz);
}
int ownerOf(ivec3 vertices) {
  return int(texelFetch(vertexWords, vertices.x).w);
}

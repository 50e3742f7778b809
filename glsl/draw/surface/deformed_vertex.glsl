// Vertices of an undeformed mesh that the vertex shader displaces (technique "vertex-shader").
#include "common/exact.glsl"
#include "mesh/types.glsl"
layout(std140, binding = deformBinding) uniform DeformBlock { DeformStep deformStep; };
layout(binding = trailUnit) uniform samplerBuffer trail;

vec4 loadTrail(int i) {
  return texelFetch(trail, i);
}
#include "mesh/model.glsl"

// Returns the normal of the displaced mesh, which does not have unit length. Uses four displaced points at the distance
// `spacing` along tangent and bitangent. `spacing` is the length of the shortest edge at the vertex (m).
vec3 displacedNormal(vec3 rest, vec3 normal, float spacing) {
  vec3 tangent = normalize(abs(normal.x) < 0.7 ? cross(normal, cross(vec3(1, 0, 0), normal))
                                               : cross(normal, cross(vec3(0, 0, 1), normal)));
  vec3 bitangent = cross(normal, tangent);
  vec3 offsets[4] = vec3[](tangent, -tangent, bitangent, -bitangent);
  vec3 ends[4];
  for (int i = 0; i < 4; ++i) ends[i] = displaced(rest + spacing * offsets[i]);
  return cross(ends[0] - ends[1], ends[2] - ends[3]);
}

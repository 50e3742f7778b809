// Interpolates the positions and normals of a surface's vertices between two frames. One invocation handles one vertex.
#include "draw/bindings.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/motion/between.glsl"
layout(local_size_x = 64) in;
layout(binding = positionUnit) uniform samplerBuffer placesBefore;
layout(binding = normalUnit) uniform samplerBuffer normalsBefore;
layout(binding = vertexUnit) uniform samplerBuffer placesNow;
layout(binding = ownerUnit) uniform samplerBuffer normalsNow;
layout(std430, binding = outVertexBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outNormalBinding) writeonly restrict buffer NormalBlock { vec4 directions[]; };
uniform int vertexCount;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= vertexCount) return;
  vec4 now = texelFetch(placesNow, i);
  places[i] = vec4(between(texelFetch(placesBefore, i).xyz, now.xyz), now.w);
  directions[i] = vec4(between(texelFetch(normalsBefore, i).xyz, texelFetch(normalsNow, i).xyz), 0.0f);
}

// Interpolates instances between two frames. An instance that is new at its index moves along its velocity instead. An
// instance counts as new if the previous frame had no instance at this index, if the instance is younger than that one
// was, or if it moved more than twice as far as both velocities allow. One invocation handles one instance.
#include "draw/bindings.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/motion/between.glsl"
layout(local_size_x = 64) in;
layout(binding = positionUnit) uniform samplerBuffer placesBefore;
layout(binding = velocityUnit) uniform samplerBuffer velocitiesBefore;
layout(binding = vertexUnit) uniform samplerBuffer placesNow;
layout(binding = ownerUnit) uniform samplerBuffer velocitiesNow;
layout(std430, binding = outVertexBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outNormalBinding) writeonly restrict buffer VelocityBlock { vec4 motions[]; };
uniform int elementCount;
uniform float seconds;  // time between the two frames in seconds

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= elementCount) return;
  vec4 before = texelFetch(placesBefore, i), now = texelFetch(placesNow, i);
  vec4 velocityBefore = texelFetch(velocitiesBefore, i), velocity = texelFetch(velocitiesNow, i);
  precise vec3 way = now.xyz - before.xyz;
  precise float swiftest = 2.0f * (exactDot(velocity.xyz, velocity.xyz) + exactDot(velocityBefore.xyz, velocityBefore.xyz));
  // Upper bound of (2 (|v| + |v before|) t)^2, the square of twice the movement that both velocities allow.
  precise float farthest = 4.0f * swiftest * seconds * seconds;
  bool same = velocityBefore.w >= 0.0f && velocity.w >= velocityBefore.w && exactDot(way, way) <= farthest;
  precise float rest = (1.0f - part) * seconds;
  precise vec3 along = now.xyz - rest * velocity.xyz;
  places[i] = vec4(same ? between(before.xyz, now.xyz) : along, now.w);
  motions[i] = velocity;
}

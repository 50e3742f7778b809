// Copies the positions and velocities of instances for use in the next frame. One invocation copies one instance.
#include "draw/bindings.glsl"
#include "draw/exact/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = positionUnit) uniform samplerBuffer positions;
layout(binding = velocityUnit) uniform samplerBuffer velocities;
layout(std430, binding = outVertexBinding) writeonly restrict buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = outNormalBinding) writeonly restrict buffer VelocityBlock { vec4 motions[]; };
uniform int elementCount;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= elementCount) return;
  places[i] = texelFetch(positions, i);
  motions[i] = texelFetch(velocities, i);
}

// Appends the balls of instances to the ray scene: centre and radius (m; 0 for hidden balls), colour and index in the
// material table. One invocation handles one instance.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/instances/instance_source.glsl"
#include "draw/instances/instance_list.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = outPlaceBinding) writeonly restrict buffer PlaceBlock { vec4 balls[]; };
layout(std430, binding = outWordBinding) writeonly restrict buffer LookBlock { vec4 ballLooks[]; };
uniform int firstBall;
uniform float owner;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= capacity) return;
  vec4 position = texelFetch(positions, i), velocity = texelFetch(velocities, i);
  float radius = radiusOf(position, velocity);
  balls[firstBall + i] = radius > 0.0f ? vec4(position.xyz, radius) : vec4(0);
  ballLooks[firstBall + i] = vec4(tintOf(position, velocity), owner);
}

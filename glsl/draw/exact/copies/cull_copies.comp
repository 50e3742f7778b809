// Lists the mesh copies that may be visible to the camera, in any order. SUN_MAP: lists the copies that may cast a
// shadow into the sun's shadow map instead. One invocation tests one copy.
#define EXACT_PICTURE
#include "draw/exact/instances/ball_source.glsl"
#ifdef SUN_MAP
#include "draw/exact/light_place.glsl"
uniform int mapTexels;
#endif
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) writeonly restrict buffer ListBlock { uint listedCopies[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
#include "draw/exact/list_place.glsl"
uniform int draw_;
uniform int firstListed;

#ifdef SUN_MAP
bool isSeen(vec4 position, float radius) {
  vec3 place = lightPlace(position.xyz);
  precise float reach = radius * exactReciprocal(lightTexel()) + 1.0f;
  precise vec2 low = place.xy * float(mapTexels) + reach;
  precise vec2 high = place.xy * float(mapTexels) - reach;
  return min(low.x, low.y) >= 0.0f && max(high.x, high.y) <= float(mapTexels);
}
#else
bool isSeen(vec4 position, float radius) {
  Ball ball = ballAt(position.xyz, radius, view.eye.xyz, view.forward.xyz);
  precise float farthest = ball.depth + radius;
  vec2 x = spanOf(ball, view.across.xyz, view.size.x);
  vec2 y = spanOf(ball, view.down.xyz, view.size.y);
  return farthest >= view.near && x.x <= x.y && y.x <= y.y;
}
#endif

void main() {
  int slot = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (slot >= capacity) return;
  vec4 position = texelFetch(positions, slot);
  // The radius is slightly enlarged to allow for the rounding of vertices.
  precise float radius = 1.001f * radiusOf(position, texelFetch(velocities, slot));
  if (!(radius > 0.0f) || radius > 1e9f || !isSeen(position, radius)) return;
  listedCopies[firstListed + int(nextPlace(draw_))] = uint(slot);
}

// Counts the rays of a range that trace.comp traces (length above 0), for `simreel bench`. One invocation tests one
// ray.
#include "draw/exact/rays/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = rayUnit) uniform samplerBuffer rays;
layout(std430, binding = outCountBinding) restrict buffer CountBlock { uint rayTotal; };
uniform int firstRay;
uniform int rayCount;
shared uint ofGroup;

void main() {
  if (gl_LocalInvocationIndex == 0u) ofGroup = 0u;
  barrier();
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i < rayCount && texelFetch(rays, 2 * (firstRay + i) + 1).w > 0.0f) atomicAdd(ofGroup, 1u);
  barrier();
  if (gl_LocalInvocationIndex == 0u) atomicAdd(rayTotal, ofGroup);
}

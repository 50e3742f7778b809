// Fades the streaks once per frame. One invocation per cell.
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "fluid/tracers/tracer_types.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = trailBinding) restrict buffer TrailBlock { uint trail[]; };
uniform int count;
uniform float kept;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  precise float left = float(int(trail[i])) * kept;
  trail[i] = uint(int(floor(left)));
}

// Extends the bounding box, stored as ordered keys, by all triangles. BALLS: by all balls instead. Each invocation
// first reduces the items of a strided range, then updates the box with atomics.
#include "draw/exact/rays/solids.glsl"
#include "draw/ordered_key.glsl"
layout(local_size_x = 64) in;
// Bounding box as six keys: low x, y, z, then high x, y, z.
layout(std430, binding = rayBoundsBinding) restrict buffer BoundsBlock { uint bounds[]; };
uniform int count;
uniform int invocations;

void main() {
  int first = int(gl_GlobalInvocationID.x);
  if (first >= min(invocations, count)) return;
  vec3 low = vec3(3.4e38), high = vec3(-3.4e38);
  for (int i = first; i < count; i += invocations) {
    Solid solid = solidOf(i);
    if (!solid.there) continue;
    low = min(low, solid.low);
    high = max(high, solid.high);
  }
  if (low.x > high.x) return;
  for (int axis = 0; axis < 3; ++axis) {
    atomicMin(bounds[axis], orderedKey(low[axis]));
    atomicMax(bounds[3 + axis], orderedKey(high[axis]));
  }
}

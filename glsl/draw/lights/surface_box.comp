// Extends the bounding box of one surface in world space, stored as ordered keys. Each invocation first reduces the
// vertices of a strided range, then updates the box with atomics.
#include "draw/frame_block.glsl"
#include "draw/ordered_key.glsl"
#include "draw/surface/vertex_pull.glsl"
layout(local_size_x = 64) in;
// Bounding box of each surface as six keys: low x, y, z, then high x, y, z.
layout(std430, binding = boxBinding) restrict buffer BoxBlock { uint boxes[]; };
uniform int surface;
uniform int vertexCount;
uniform int invocations;

void main() {
  int first = int(gl_GlobalInvocationID.x);
  if (first >= min(invocations, vertexCount)) return;
  vec3 low = vec3(3.4e38), high = vec3(-3.4e38);
  for (int i = first; i < vertexCount; i += invocations) {
    vec3 p = worldPoint(i);
    precise float far = abs(p.x) + abs(p.y) + abs(p.z);
    if (!(isNumber(far) && far < 1e9)) continue;  // skips vertices that are not finite or very far away
    low = min(low, p);
    high = max(high, p);
  }
  if (low.x > high.x) return;
  for (int axis = 0; axis < 3; ++axis) {
    atomicMin(boxes[6 * surface + axis], orderedKey(low[axis]));
    atomicMax(boxes[6 * surface + 3 + axis], orderedKey(high[axis]));
  }
}

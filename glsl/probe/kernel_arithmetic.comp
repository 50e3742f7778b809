// Evaluates reciprocals and roots of users' kernels, and products and sums near the smallest normal number, to find how
// the driver rounds. One invocation per pair of inputs.
#include "kernels/numbers.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer InputBlock { vec2 pairs[]; };
layout(std430, binding = 1) writeonly buffer OutputBlock { vec4 results[]; };
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec2 p = pairs[i];
  precise float product = p.x * p.y;
  precise float sum = p.x + p.y;
  results[i] = vec4(xReciprocal(p.x), xSqrt(p.x), product, sum);
}

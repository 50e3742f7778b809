// Adds a position-dependent hash of every four words to a 128-bit sum. Sums of integers do not depend on
// order, so the result is the same on every driver and for every number of work groups.
#include "common/hash.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform usamplerBuffer words;
layout(std430, binding = 0) restrict buffer SumBlock { uint sums[]; };
uniform int texels;
uniform int perInvocation;
uniform int slot;
uniform uint salt;

void main() {
  int first = int(gl_GlobalInvocationID.x) * perInvocation;
  int last = min(first + perInvocation, texels);
  uvec4 total = uvec4(0u);
  for (int i = first; i < last; ++i) {
    uvec4 w = texelFetch(words, i);
    uvec3 a = hash3(uvec3(w.x ^ uint(i), w.y, w.z ^ salt));
    uvec3 b = hash3(uvec3(w.w + a.x, a.y, a.z ^ uint(i)));
    total += uvec4(a.x ^ b.y, b);
  }
  if (first < last) {
    atomicAdd(sums[slot * 4], total.x);
    atomicAdd(sums[slot * 4 + 1], total.y);
    atomicAdd(sums[slot * 4 + 2], total.z);
    atomicAdd(sums[slot * 4 + 3], total.w);
  }
}

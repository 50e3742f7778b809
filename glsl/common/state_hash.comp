// Adds a position-dependent hash of each element (four words) to a 128-bit sum. Integer sums do not depend on the order
// of addition, so the result is the same on every driver and for every number of workgroups. If GROUPED is defined (for
// GPUs), neighbouring invocations read neighbouring elements, and a workgroup sums its hashes before it adds them to
// the total.
#include "common/bindings.glsl"
#include "common/hash.glsl"
layout(std430, binding = sumsBinding) restrict buffer SumBlock { uint sums[]; };
uniform int texels;
uniform int slot;
uniform uint salt;
#include "common/state_words.glsl"

uvec4 hashOf(int i) {
  uvec4 w = elementAt(i);
  uvec3 a = hash3(uvec3(w.x ^ uint(i), w.y, w.z ^ salt));
  uvec3 b = hash3(uvec3(w.w + a.x, a.y, a.z ^ uint(i)));
  return uvec4(a.x ^ b.y, b);
}

#ifdef GROUPED
layout(local_size_x = 256) in;
shared uvec4 totals[256];
uniform int invocations;

void main() {
  int own = int(gl_LocalInvocationID.x);
  uvec4 total = uvec4(0u);
  for (int i = int(gl_GlobalInvocationID.x); i < texels; i += invocations) total += hashOf(i);
  totals[own] = total;
  for (int reach = 128; reach > 0; reach >>= 1) {
    barrier();
    if (own < reach) totals[own] += totals[own + reach];
  }
  barrier();
  if (own < 4) atomicAdd(sums[slot * 4 + own], totals[0][own]);
}
#else
layout(local_size_x = 64) in;
uniform int perInvocation;

void main() {
  int first = int(gl_GlobalInvocationID.x) * perInvocation;
  int last = min(first + perInvocation, texels);
  uvec4 total = uvec4(0u);
  for (int i = first; i < last; ++i) total += hashOf(i);
  if (first < last)
    for (int i = 0; i < 4; ++i) atomicAdd(sums[slot * 4 + i], total[i]);
}
#endif

// Integer hashes of a state array, added up block by block, and one sum in which each hash counts as often as
// its place says: from it follows where a single difference is. Sums of integers do not depend on order.
#include "common/bindings.glsl"
#include "common/hash.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = sumsBinding) restrict buffer SumBlock { uint sums[]; };
uniform int texels;
#include "common/state_words.glsl"
uniform int perInvocation;  // divides perBlock
uniform int perBlock;
uniform int place;  // of the array's sums: one for each block, then the weighted one

void main() {
  int first = int(gl_GlobalInvocationID.x) * perInvocation;
  int last = min(first + perInvocation, texels);
  if (first >= last) return;
  uint total = 0u;
  uint weighted = 0u;
  for (int i = first; i < last; ++i) {
    uvec4 w = elementAt(i);
    uvec3 a = hash3(uvec3(w.x ^ uint(i), w.y, w.z));
    uint h = hash3(uvec3(w.w + a.x, a.y, a.z ^ uint(i))).x;
    total += h;
    weighted += h * uint(i + 1);
  }
  atomicAdd(sums[place + first / perBlock], total);
  atomicAdd(sums[place + (texels - 1) / perBlock + 1], weighted);
}

// Hashes each element of a state array. The integer hashes are added up block by block, and also in one weighted sum
// over the whole array, in which each hash is multiplied by its 1-based element index. If two arrays differ in a single
// element, the sums give the index of that element. Integer sums do not depend on the order of addition. An invocation
// hashes `perInvocation` elements.
#include "common/bindings.glsl"
#include "common/hash.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = sumsBinding) restrict buffer SumBlock { uint sums[]; };
uniform int texels;
#include "common/state_words.glsl"
uniform int perInvocation;  // number of elements that an invocation hashes; divides perBlock
uniform int perBlock;
uniform int place;  // index of this array's first sum; there is one sum per block, followed by the weighted sum

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

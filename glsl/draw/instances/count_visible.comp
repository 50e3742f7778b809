// Computes prefix sums of the number of visible instances within blocks of 64 mask words. One invocation handles one
// block.
#include "draw/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = maskUnit) uniform usamplerBuffer masks;
layout(std430, binding = beforeBinding) writeonly restrict buffer BeforeBlock { uint before[]; };
layout(std430, binding = blockCountBinding) writeonly restrict buffer BlockBlock { uint blockCount[]; };
uniform int blocks;

void main() {
  int block = int(gl_GlobalInvocationID.x);
  if (block >= blocks) return;
  uint sum = 0u;
  for (int word = block * 64; word < block * 64 + 64; ++word) {
    before[word] = sum;
    sum += uint(bitCount(texelFetch(masks, word).x));
  }
  blockCount[block] = sum;
}

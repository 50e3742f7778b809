// Writes the indices of the visible instances, sorted by level of detail and then by index. One invocation handles one
// word of the bit mask.
#include "draw/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = maskUnit) uniform usamplerBuffer masks;
layout(binding = beforeUnit) uniform usamplerBuffer before;
layout(binding = blockFirstUnit) uniform usamplerBuffer blockFirst;
layout(std430, binding = listBinding) writeonly restrict buffer ListBlock { uint list[]; };
uniform int allWords;
uniform int words;  // number of mask words of one level of detail

void main() {
  int word = int(gl_GlobalInvocationID.x);
  if (word >= allWords) return;
  uint mask = texelFetch(masks, word).x;
  if (mask == 0u) return;
  uint at = texelFetch(blockFirst, word / 64).x + texelFetch(before, word).x;
  uint slot = uint(word % words) * 32u;
  while (mask != 0u) {
    list[at++] = slot + uint(findLSB(mask));
    mask &= mask - 1u;
  }
}

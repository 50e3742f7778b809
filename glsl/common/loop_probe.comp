// Counts to `rounds` in a loop and stores the number, to detect software drivers that silently end a loop after 65,535
// iterations. One invocation in total.
#include "common/bindings.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = outputsBinding) writeonly restrict buffer OutputBlock { uint reached; };
uniform int rounds;

void main() {
  uint n = 0u;
  for (int i = 0; i < rounds; ++i) n = (n + 1u) ^ uint(i & 0);
  reached = n;
}

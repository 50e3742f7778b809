// Finds the nearest face of each grid node. One invocation per node. Each dispatch runs `rounds` steps of the search.
// The dispatch is repeated until `left` is 0, because software drivers silently end loops after 65,535 iterations per
// invocation.
#include "collide/distance/kernel.glsl"
layout(std430, binding = leftBinding) restrict buffer LeftBlock { uint left; };
uniform int rounds;
uniform bool begins;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= nodes.w) return;
  vec3 p = placeOf(i);
  Search s;
  if (begins) {
    s = begun(p);
  } else {
    uvec4 words = LOAD_WORDS(searches, i);
    s.squared = intBitsToFloat(int(words.x));
    s.face = int(words.y);
    s.box = int(words.z);
  }
  for (int k = 0; k < rounds && s.box != 0; ++k) s = searched(p, s);
  STORE_WORDS(searches, i, uvec4(uint(floatBitsToInt(s.squared)), uint(s.face), uint(s.box), 0u));
  if (s.box != 0) atomicAdd(left, 1u);
}

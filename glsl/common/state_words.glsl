// The elements of a state array, four words each: in their order, or (PLANES) all first words, then all second ones and so on
// (src/sim/core/state_array.hpp). Before: `texels`, how many there are.
#include "common/bindings.glsl"
#ifdef PLANES
layout(std430, binding = planesBinding) readonly restrict buffer PlaneBlock { uint planeWords[]; };
uniform int planes;  // the other words are 0

uint wordIn(int plane, int i) {
  return plane < planes ? planeWords[plane * texels + i] : 0u;
}

uvec4 elementAt(int i) {
  return uvec4(wordIn(0, i), wordIn(1, i), wordIn(2, i), wordIn(3, i));
}
#else
layout(binding = wordsBinding) uniform usamplerBuffer words;

uvec4 elementAt(int i) {
  return texelFetch(words, i);
}
#endif

// Access to the elements of a state array, four words per element. The words are stored element by element or, if
// PLANES is defined, as all first words, then all second words and so on (src/sim/core/state_array.hpp). The including
// file must declare `texels`, the number of elements, before the include.
#include "common/bindings.glsl"
#ifdef PLANES
layout(std430, binding = planesBinding) readonly restrict buffer PlaneBlock { uint planeWords[]; };
uniform int planes;  // number of stored planes; the words of all other planes read as 0

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

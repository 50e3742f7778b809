// Values that colour a surface, if TINTED is defined.
#ifdef TINTED
layout(binding = tintsUnit) uniform usamplerBuffer tintWords;
uniform ivec2 tintLayout;
uniform vec2 tintRange;  // Lowest value, and 1 / (highest value - lowest value)

float tintAt(ivec3 cell) {
  int word = cellWord(clamp(cell, ivec3(0), volume.xyz - 1), tintLayout);
  return numberOf(wordOf(texelFetch(tintWords, word >> 2), word & 3));
}
#endif

// Values of a volume's cells in the format of the simulation: floats, in rows of cells and layers of rows.
layout(binding = valuesUnit) uniform usamplerBuffer valueWords;
uniform ivec2 valueLayout;  // x: number of words per row; y: index of the first cell's word
uniform float level;

// Returns the value of a word. NaN and infinity count as below every level.
float numberOf(uint word) {
  float value = uintBitsToFloat(word);
  return isNumber(value) ? clamp(value, -1e20, 1e20) : -1e20;
}
uint wordOf(uvec4 four, int i) {
  return (i & 2) == 0 ? ((i & 1) == 0 ? four.x : four.y) : ((i & 1) == 0 ? four.z : four.w);
}
int cellWord(ivec3 cell, ivec2 layout_) {
  return layout_.y + (cell.z * volume.y + cell.y) * layout_.x + cell.x;
}
// Returns the value of the nearest cell inside the volume.
float valueAt(ivec3 cell) {
  int word = cellWord(clamp(cell, ivec3(0), volume.xyz - 1), valueLayout);
  return numberOf(wordOf(texelFetch(valueWords, word >> 2), word & 3));
}

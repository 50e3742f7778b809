// Values of a volume's cells, as a simulation keeps them: floats, a row after the other, layers of rows.
layout(binding = valuesUnit) uniform usamplerBuffer valueWords;
uniform ivec2 valueLayout;  // words from one row to the next; of the first cell
uniform float level;

// What is no number lies below every level.
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
// Of the nearest cell that there is.
float valueAt(ivec3 cell) {
  int word = cellWord(clamp(cell, ivec3(0), volume.xyz - 1), valueLayout);
  return numberOf(wordOf(texelFetch(valueWords, word >> 2), word & 3));
}

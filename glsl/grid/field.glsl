// Access to the values of a field in the simulation's format (src/sim/core/drawable.hpp). CELLS is 0 for bits, 1 for
// bytes, 2 for floats, 3 for colours followed by the value.
layout(binding = fieldUnit) uniform usamplerBuffer fieldWords;
uniform ivec2 fieldSize;  // Number of cells per axis
uniform int rowWords;     // Number of words per row
uniform int firstWord;    // Index of the word of cell (0, 0)
uniform int cellWords;    // Number of words per cell, for floats and colours

uint fieldWord(int i) {
  uvec4 four = texelFetch(fieldWords, i >> 2);
  return (i & 2) == 0 ? ((i & 1) == 0 ? four.x : four.y) : ((i & 1) == 0 ? four.z : four.w);
}

// Returns the value of a cell. A cell outside the field has the value of the nearest cell inside. NaN and infinity
// count as the lowest value.
float valueAt(ivec2 cell) {
  cell = clamp(cell, ivec2(0), fieldSize - 1);
  int row = firstWord + cell.y * rowWords;
#if CELLS == 0
  return float(fieldWord(row + (cell.x >> 5)) >> uint(cell.x & 31) & 1u);
#elif CELLS == 1
  return float(fieldWord(row + (cell.x >> 2)) >> uint(8 * (cell.x & 3)) & 255u);
#else
  const int behind = CELLS == 3 ? 3 : 0;
  float value = uintBitsToFloat(fieldWord(row + cell.x * cellWords + behind));
  return isNumber(value) ? clamp(value, -1e20, 1e20) : -1e20;
#endif
}

// The field's values, as its simulation keeps them (src/sim/core/drawable.hpp). CELLS: 0 bits, 1 bytes, 2 floats, 3 colours
// with the value behind them.
layout(binding = fieldUnit) uniform usamplerBuffer fieldWords;
uniform ivec2 fieldSize;  // cells
uniform int rowWords;     // from one row to the next
uniform int firstWord;    // of cell (0, 0)
uniform int cellWords;    // of floats: from a cell to the next

uint fieldWord(int i) {
  uvec4 four = texelFetch(fieldWords, i >> 2);
  return (i & 2) == 0 ? ((i & 1) == 0 ? four.x : four.y) : ((i & 1) == 0 ? four.z : four.w);
}

// Of a cell of the field; of one outside the nearest inside. A lost number counts as the lowest.
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

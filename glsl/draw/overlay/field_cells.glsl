// A field's cells as its simulation keeps them. CELLS: 0 bits, 1 bytes, 2 floats.
#include "draw/bindings.glsl"
layout(binding = wordUnit) uniform usamplerBuffer words;
uniform ivec2 cells;     // of the field
uniform int rowWords;    // from one row to the next
uniform int firstWord;   // of cell (0, 0)
uniform int cellWords;   // of floats: from a cell to the next

uint wordAt(int i) {
  uvec4 four = texelFetch(words, i >> 2);
  return (i & 2) == 0 ? ((i & 1) == 0 ? four.x : four.y) : ((i & 1) == 0 ? four.z : four.w);
}

float valueOf(ivec2 cell) {
  int row = firstWord + cell.y * rowWords;
#if CELLS == 0
  return float(wordAt(row + (cell.x >> 5)) >> uint(cell.x & 31) & 1u);
#elif CELLS == 1
  return float(wordAt(row + (cell.x >> 2)) >> uint(8 * (cell.x & 3)) & 255u);
#else
  return uintBitsToFloat(wordAt(row + cell.x * cellWords));
#endif
}

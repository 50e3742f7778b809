// Larger than Life with squares, second pass: computes running sums of the column sums along a row, then applies the
// rule. Defines: as for columns.comp and wide.glsl; ITEMS, the number of elements that an invocation writes.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = wordsBinding) uniform usamplerBuffer paddedWords;
layout(binding = sumsBinding) uniform usamplerBuffer columnWords;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int rowWords;
uniform int marginX;
#include "automata/wide.glsl"
#include "automata/output.glsl"

// Returns the four bytes that begin at bit `shift` of the first word.
uint fourBytes(uint first, uint second, uint shift) {
  return shift == 0u ? first : first >> shift | second << (32u - shift);
}
uint columnsAt(int i) {
  return texelFetch(columnWords, i).x;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  int firstItem = at.x * ITEMS;
  if (firstItem >= rowItems || at.y >= size.y) return;
  int column = marginX + firstItem * CELLS;
  int row = at.y * rowWords;
  int total = 0;
  for (int dx = -RANGE; dx <= RANGE; ++dx) {
    int byte = column + dx;
    total += int(columnsAt(row + (byte >> 2)) >> uint((byte & 3) * 8) & 255u);
  }
  // Columns whose sum is added for the next cell (in_), and whose sum is subtracted after this cell (out_).
  int in_ = column + RANGE + 1;
  int out_ = column - RANGE;
  uint inWord = columnsAt(row + (in_ >> 2));
  uint outWord = columnsAt(row + (out_ >> 2));
  uint inShift = uint((in_ & 3) * 8);
  uint outShift = uint((out_ & 3) * 8);
  int cellPlace = (at.y + RANGE) * rowWords + column / 4;
  for (int item = 0; item < ITEMS; ++item) {
    uvec4 block = uvec4(0u);
    for (int word = 0; word < CELLS / 4; ++word) {
      int i = item * (CELLS / 4) + word;
      uint inNext = columnsAt(row + (in_ >> 2) + i + 1);
      uint outNext = columnsAt(row + (out_ >> 2) + i + 1);
      uint entering = fourBytes(inWord, inNext, inShift);
      uint leaving = fourBytes(outWord, outNext, outShift);
      inWord = inNext;
      outWord = outNext;
      uint here = texelFetch(paddedWords, cellPlace + i).x;
      uint bytes = 0u;
      for (int j = 0; j < 4; ++j) {
        bytes |= wideNext(here >> uint(8 * j) & 255u, total) << uint(8 * j);
        total += int(entering >> uint(8 * j) & 255u) - int(leaving >> uint(8 * j) & 255u);
      }
      collect(block, word, bytes, size.x - (firstItem + item) * CELLS - word * 4);
    }
    if (firstItem + item < rowItems) STORE_WORDS(newCells, at.y * rowItems + firstItem + item, block);
  }
}

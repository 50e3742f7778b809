// Larger than Life on circles and diamonds: from a cell to the next one comes the right end of each row around it and goes
// the left one. An invocation goes along a row, those beside it along the rows below, for a row has few elements and a
// software driver runs eight invocations of a group's x at once. Defines: as rows.comp; LEFTS, RIGHTS: columns from a
// cell's own to the first and the last cell of each row, from the top.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 32) in;
layout(binding = bytesBinding) uniform usamplerBuffer paddedBytes;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int rowWords;
uniform int marginX;
#include "automata/wide.glsl"
#include "automata/output.glsl"
const int lefts[2 * RANGE + 1] = int[](LEFTS);
const int rights[2 * RANGE + 1] = int[](RIGHTS);

int aliveAt(int i) {
  return texelFetch(paddedBytes, i).x == 1u ? 1 : 0;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.yx);
  int firstItem = at.x * ITEMS;
  if (firstItem >= rowItems || at.y >= size.y) return;
  int rowBytes = rowWords * 4;
  int top = at.y * rowBytes + marginX + firstItem * CELLS;
  int total = 0;
  for (int i = 0; i <= 2 * RANGE; ++i)
    for (int dx = lefts[i]; dx <= rights[i]; ++dx) total += aliveAt(top + i * rowBytes + dx);
  for (int item = 0; item < ITEMS; ++item) {
    uvec4 block = uvec4(0u);
    for (int word = 0; word < CELLS / 4; ++word) {
      uint bytes = 0u;
      for (int j = 0; j < 4; ++j) {
        int x = top + item * CELLS + word * 4 + j;
        bytes |= wideNext(texelFetch(paddedBytes, x + RANGE * rowBytes).x, total) << uint(8 * j);
        for (int i = 0; i <= 2 * RANGE; ++i)
          total += aliveAt(x + i * rowBytes + rights[i] + 1) - aliveAt(x + i * rowBytes + lefts[i]);
      }
      collect(block, word, bytes, size.x - (firstItem + item) * CELLS - word * 4);
    }
    if (firstItem + item < rowItems) STORE_WORDS(newCells, at.y * rowItems + firstItem + item, block);
  }
}

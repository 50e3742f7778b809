// Larger than Life with circles and diamonds, computed by running sums: for each row of the neighbourhood, the cell at
// the right end is added and the cell at the left end is subtracted. An invocation moves along a row. Adjacent
// invocations process consecutive rows, because a row has few elements and a software driver runs eight invocations
// along x together. Defines: as for rows.comp; LEFTS and RIGHTS, the column offsets of the first and last cell of
// each row, from the top.
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

// Fills the grid randomly: a cell is alive if the hash of (x, y, seed) is below the fraction. An invocation writes a
// block of 128 cells, so that no two invocations write to the same word.
#include "common/hash.glsl"
#include "common/words.glsl"
#include "life/bindings.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(cellsBinding, CellBlock, cells)
uniform ivec2 size;
uniform int rowBlocks;
uniform int seed;
uniform int fraction;  // Fraction of live cells, multiplied by 2^24
uniform int firstBlock;

#include "life/fill.glsl"

void main() {
  int i = firstBlock + int(gl_GlobalInvocationID.x);
  int y = i / rowBlocks;
  int x = (i - y * rowBlocks) * 128;
  if (y >= size.y) return;
  uvec4 block = uvec4(0u);
  for (int word = 0; word < 4; ++word) {
    uint bits = 0u;
    for (int bit = 0; bit < 32; ++bit) {
      int column = x + word * 32 + bit;
      if (column < size.x && startsAlive(column, y, seed, fraction)) bits |= 1u << uint(bit);
    }
    block[word] = bits;
  }
  STORE_WORDS(cells, i, block);
}

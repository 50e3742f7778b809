// Applies one brush stroke. An invocation processes a block of 128 cells and paints the cells inside the brush.
#include "common/words.glsl"
#include "life/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
STATE_WORDS(cellsBinding, CellBlock, cells)
#include "grid/stroke_paint.glsl"
uniform int rowBlocks;

void main() {
  int left = strokeBox.x >> 7;
  int blocks = (strokeBox.x + strokeBox.z - 1 >> 7) - left + 1;
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= blocks || at.y >= strokeBox.w) return;
  int y = strokeBox.y + at.y;
  int x = (left + at.x) * 128;
  int i = y * rowBlocks + left + at.x;
  uvec4 block = LOAD_WORDS(cells, i);
  bool kills = stroke.value < 0.5f;
  for (int word = 0; word < 4; ++word) {
    uint painted = 0u;
    for (int bit = 0; bit < 32; ++bit) {
      int column = x + word * 32 + bit;
      if (column < strokeBox.x || column >= strokeBox.x + strokeBox.z) continue;
      if (strokePaints(ivec2(column, y))) painted |= 1u << uint(bit);
    }
    block[word] = kills ? block[word] & ~painted : block[word] | painted;
  }
  STORE_WORDS(cells, i, block);
}

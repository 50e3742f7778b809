// Applies one brush stroke to cells with several states. An invocation processes 16 cells and paints the cells inside
// the brush.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
STATE_WORDS(cellsBinding, CellBlock, cells)
#include "grid/stroke_paint.glsl"
uniform int rowItems;
uniform int highest;  // Maximum state

void main() {
  int left = strokeBox.x >> 4;
  int items = (strokeBox.x + strokeBox.z - 1 >> 4) - left + 1;
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= items || at.y >= strokeBox.w) return;
  int y = strokeBox.y + at.y;
  int i = y * rowItems + left + at.x;
  uvec4 block = LOAD_WORDS(cells, i);
  uint state = uint(min(strokeNumber(stroke), highest));
  for (int cell = 0; cell < 16; ++cell) {
    int column = (left + at.x) * 16 + cell;
    if (column < strokeBox.x || column >= strokeBox.x + strokeBox.z) continue;
    uint shift = uint((cell & 3) * 8);
    if (strokePaints(ivec2(column, y))) block[cell >> 2] = (block[cell >> 2] & ~(255u << shift)) | state << shift;
  }
  STORE_WORDS(cells, i, block);
}

// Applies one brush stroke. An invocation processes four adjacent cells.
#include "common/memory.glsl"
#include "common/words.glsl"
#include "lenia/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
STATE_ARRAY(cellsBinding, CellBlock, cells)
#include "grid/stroke_paint.glsl"
uniform int rowItems;

void main() {
  int left = strokeBox.x >> 2;
  int items = (strokeBox.x + strokeBox.z - 1 >> 2) - left + 1;
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= items || at.y >= strokeBox.w) return;
  int y = strokeBox.y + at.y;
  int i = y * rowItems + left + at.x;
  vec4 four = LOAD_STATE(cells, i);
  for (int cell = 0; cell < 4; ++cell) {
    int column = (left + at.x) * 4 + cell;
    if (column < strokeBox.x || column >= strokeBox.x + strokeBox.z) continue;
    if (strokePaints(ivec2(column, y))) four[cell] = stroke.value;
  }
  STORE_STATE(cells, i, four);
}

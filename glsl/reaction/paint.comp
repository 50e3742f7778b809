// Applies a brush stroke: a species gets the stroke's value. One invocation per element of four cells, in the rows that
// the stroke's bounding box covers.
#include "common/memory.glsl"
#include "common/words.glsl"
#include "reaction/bindings.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
STATE_ARRAY(nextBinding, CellBlock, cells)
INPUT_WORDS(stampsBinding, StampBlock, stamps)
#include "grid/stroke_paint.glsl"
uniform ivec2 size;
uniform int columns, plane;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= columns || at.y >= strokeBox.w) return;
  int y = strokeBox.y + at.y;
  int element = (plane * size.y + y) * columns + at.x;
  vec4 four = LOAD_STATE(cells, element);
  for (int i = 0; i < 4; ++i)
    if (4 * at.x + i < size.x && strokePaints(ivec2(4 * at.x + i, y))) four[i] = stroke.value;
  STORE_STATE(cells, element, four);
}

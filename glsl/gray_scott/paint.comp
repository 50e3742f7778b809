// Applies a brush stroke: v becomes the stroke's value, u becomes 1 - v. One invocation per element, over the complete
// rows of the stroke's box, so that the copy of cell 0 in rows of odd width is also painted.
#include "common/memory.glsl"
#include "common/words.glsl"
#include "gray_scott/bindings.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
STATE_ARRAY(cellsBinding, CellBlock, cells)
INPUT_WORDS(stampsBinding, StampBlock, stamps)
#include "grid/stroke_paint.glsl"
uniform ivec2 size;
uniform int columns;

vec2 painted(vec2 cell, int x, int y) {
  if (!strokePaints(ivec2(x < size.x ? x : 0, y))) return cell;
  precise float rest = 1.0f - stroke.value;
  return vec2(rest, stroke.value);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= columns || at.y >= strokeBox.w) return;
  int y = strokeBox.y + at.y;
  int element = y * columns + at.x;
  vec4 pair = LOAD_STATE(cells, element);
  STORE_STATE(cells, element, vec4(painted(pair.xy, 2 * at.x, y), painted(pair.zw, 2 * at.x + 1, y)));
}

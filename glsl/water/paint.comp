// Adds water: the value of a brush stroke in metres within its radius, or a drop if DROP is defined. One invocation per
// cell.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
STATE_ARRAY(cellsBinding, CellBlock, cells)
INPUT_WORDS(stampsBinding, StampBlock, stamps)
uniform ivec2 size;
uniform WaterDrop drop;
#include "grid/stroke_paint.glsl"
#include "water/model.glsl"

void main() {
  ivec2 cell;
  if (!strokeCell(gl_GlobalInvocationID.xy, cell)) return;
  int i = cell.y * size.x + cell.x;
  vec4 texel = LOAD_STATE(cells, i);
#ifdef DROP
  float rise = waterDropAt(drop, cell, texel);
#else
  float rise = strokePaints(cell) ? stroke.value : 0.0f;
#endif
  STORE_STATE(cells, i, waterRaised(texel, rise));
}

// Brush strokes on epidemics and wildfires. One invocation per element of the stroke's box, whose unit is elements. The
// including kernel provides `uint painted(uint cell, int value, ivec2 at)`, which returns the cell after the stroke.
#include "common/bindings.glsl"
#include "common/words.glsl"
#include "spread/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
STATE_WORDS(cellsBinding, CellBlock, cells)
// Class counts per step, as in rows.glsl; painting updates the counts of the painted state.
layout(std430, binding = countsBinding) restrict buffer CountBlock { uint counts[]; };
uniform ivec2 size;
uniform int countPlace;
#include "grid/stroke_paint.glsl"
#include "spread/cells.glsl"

// A brush stroke on cells; one invocation an element of the stroke's box, which is in elements. The kernel that
// includes it gives `uint painted(uint cell, int value, ivec2 at)`.
#include "common/bindings.glsl"
#include "common/words.glsl"
#include "spread/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
STATE_WORDS(cellsBinding, CellBlock, cells)
// As in rows.glsl: those of the state that is painted.
layout(std430, binding = countsBinding) restrict buffer CountBlock { uint counts[]; };
uniform ivec2 size;
uniform int countPlace;
#include "grid/stroke_paint.glsl"
#include "spread/cells.glsl"

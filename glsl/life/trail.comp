// Updates the trails after each generation. An invocation processes 16 cells.
#include "common/words.glsl"
#include "life/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(cellsBinding, CellBlock, cells)
STATE_WORDS(trailsBinding, TrailBlock, trails)
uniform ivec2 size;
uniform int rowBlocks;
uniform int rowQuads;  // Number of elements of 16 bytes per row of trails
uniform uint bright;
uniform uint drop;

#include "life/trail.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= rowQuads || at.y >= size.y) return;
  uvec4 block = LOAD_INPUT_WORDS(cells, at.y * rowBlocks + (at.x >> 3));
  uint alive = block[at.x >> 1 & 3] >> uint((at.x & 1) * 16);
  int i = at.y * rowQuads + at.x;
  uvec4 bytes = LOAD_WORDS(trails, i);
  for (int k = 0; k < 4; ++k) bytes[k] = fadedTrail(bytes[k], alive >> uint(4 * k), bright, drop);
  STORE_WORDS(trails, i, bytes);
}

// A pass of dye: what leaves a cell through a face arrives in the next one.
#define READS_DYE
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextDyeBinding, NextBlock, nextDye)

void main() {
  int x = int(gl_GlobalInvocationID.x) - 1, y = int(gl_GlobalInvocationID.y) - 1;
  if (x > size.x || y > size.y) return;
  STORE_STATE(nextDye, elementOf(x, y), dyedCell(x, y));
}

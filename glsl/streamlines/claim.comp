// Claims for this round the cells in which the points of each line are. One invocation per line.
#include "streamlines/claims.glsl"

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= count) return;
  ivec4 span = spans[line];
  uint claim = massWeightOf(line);
  for (int i = span.x; i <= span.y; ++i) {
    ivec2 cell = cellOf(LOAD_STATE(points, line * perLine + i).xyz);
    atomicMin(claims[cell.y * cellCount.x + cell.x], claim);
  }
}

// Marks all cells as not reached. The start cell is set afterwards. One invocation per cell.
#include "cave/wave.glsl"

void main() {
  if (gl_GlobalInvocationID.x >= 32u * uint(rowWords)) return;
  distances[numberOf(int(gl_GlobalInvocationID.x), int(gl_GlobalInvocationID.y))] = nowhere;
}

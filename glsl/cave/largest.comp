// Finds the region with the most cells. Pass 0 finds the number of cells. Pass 1 finds, among the regions with this
// number, the one with the lowest first cell.
#include "cave/runs.glsl"
layout(local_size_x = 64) in;
uniform int pass;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords;
  for (uint starts = startsOf(kindAt(i - y * rowWords, y)); starts != 0u; starts &= starts - 1u) {
    uint run = uint(32 * i + findLSB(starts));
    if (labels[run] != run) continue;
    if (pass == 0)
      atomicMax(greatest, tally[run]);
    else if (tally[run] == greatest)
      atomicMin(first, run);
  }
}

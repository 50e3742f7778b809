// The region with the most cells; of several the one with the lowest cell, which a second pass finds.
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

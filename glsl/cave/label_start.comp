// Starts the labelling: every run becomes a separate region.
#include "cave/runs.glsl"
layout(local_size_x = 64) in;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords;
  uint starts = startsOf(kindAt(i - y * rowWords, y));
  for (; starts != 0u; starts &= starts - 1u) {
    int run = 32 * i + findLSB(starts);
    labels[run] = uint(run);
    tally[run] = 0u;
  }
}

// Completes the labelling after convergence: each run's label becomes the run's region, and the cells of each region
// are counted.
#include "cave/runs.glsl"
layout(local_size_x = 64) in;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords;
  uint here = kindAt(i - y * rowWords, y);
  for (uint starts = startsOf(here); starts != 0u; starts &= starts - 1u) {
    int begin = findLSB(starts);
    uint region = labels[labels[32 * i + begin]];
    labels[32 * i + begin] = region;
    atomicAdd(tally[region], uint(endOf(here, begin) - begin));
  }
}

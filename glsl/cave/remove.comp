// Converts regions with fewer than `fewest` cells to the other kind, except for the region whose lowest cell is `kept`.
#include "cave/runs.glsl"
layout(local_size_x = 64) in;
uniform uint fewest;
uniform uint kept;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords;
  uint here = kindAt(i - y * rowWords, y), turned = 0u;
  for (uint starts = startsOf(here); starts != 0u; starts &= starts - 1u) {
    int begin = findLSB(starts);
    uint region = labels[32 * i + begin];
    if (tally[region] < fewest && region != kept) turned |= bitsOf(begin, endOf(here, begin));
  }
  if (turned != 0u) cells[i] ^= turned;
}

// Fills the cells randomly, by a hash of position and seed. One invocation per word of cells.
#include "common/hash.glsl"
#include "cave/cells.glsl"
layout(local_size_x = 64) in;
uniform uint seed;
uniform uint threshold;  // 2^32 times the probability of rock

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords, first = 32 * (i - y * rowWords);
  uint word = 0u;
  for (int bit = 0; bit < 32; ++bit)
    if (startsAsRock(first + bit, y, size, seed, threshold)) word |= 1u << uint(bit);
  cells[i] = word;
}

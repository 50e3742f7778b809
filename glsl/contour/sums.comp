// Prefix sum of the tallies, step 1 of 3: computes the sum of each tile. One invocation per tile.
#include "common/words.glsl"
#include "contour/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
STATE_WORDS(tileSumsBinding, TileBlock, tileSums)
uniform int count;
uniform int tile;  // Number of tallies per tile

void main() {
  int t = int(gl_GlobalInvocationID.x), begin = t * tile;
  if (begin >= count) return;
  uvec4 sum = uvec4(0);
  for (int i = begin; i < min(begin + tile, count); ++i) sum += LOAD_INPUT_WORDS(tallies, i);
  STORE_WORDS(tileSums, t, sum);
}

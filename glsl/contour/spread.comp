// Prefix sum, step 3 of 3: replaces x, y and z of every tally by the sums over all tallies before it; w does not
// change. One invocation per tile.
#include "common/words.glsl"
#include "contour/bindings.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(talliesBinding, TallyBlock, tallies)
INPUT_WORDS(tileSumsBinding, TileBlock, tileSums)
uniform int count;
uniform int tile;  // Number of tallies per tile

void main() {
  int t = int(gl_GlobalInvocationID.x), begin = t * tile;
  if (begin >= count) return;
  uvec4 before = LOAD_INPUT_WORDS(tileSums, t);
  for (int i = begin; i < min(begin + tile, count); ++i) {
    uvec4 mine = LOAD_WORDS(tallies, i);
    STORE_WORDS(tallies, i, uvec4(before.xyz, mine.w));
    before += mine;
  }
}

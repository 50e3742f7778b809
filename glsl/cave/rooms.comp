// Initializes the search for connections. The nearest open cell of each cell is the cell itself or none. The tree of
// each room is the room itself, without a connection.
#include "cave/runs.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = sourcesBinding) restrict writeonly buffer SourceBlock { uint sources[]; };
layout(std430, binding = weightsBinding) restrict writeonly buffer WeightBlock { uint weights[]; };
layout(std430, binding = edgesBinding) restrict writeonly buffer EdgeBlock { uint edges[]; };

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords;
  uint here = kindAt(i - y * rowWords, y);
  for (int bit = 0; bit < 32; ++bit) sources[32 * i + bit] = (here >> uint(bit) & 1u) != 0u ? uint(32 * i + bit) : nowhere;
  for (uint starts = startsOf(here); starts != 0u; starts &= starts - 1u) {
    int run = 32 * i + findLSB(starts);
    tally[run] = labels[run];
    weights[run] = nowhere;
    edges[run] = nowhere;
  }
}

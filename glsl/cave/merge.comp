// Assigns every room to the tree that the room's tree has joined, and clears the trees' connections for the next round.
// One invocation per word of cells.
#include "cave/trees.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  for (uint starts = openStarts(i); starts != 0u; starts &= starts - 1u) {
    uint room = uint(32 * i + findLSB(starts));
    if (!isRoom(room)) continue;
    trees[room] = links[trees[room]];
    weights[room] = nowhere;
    edges[room] = nowhere;
  }
}

// Pointer jumping. Replaces each room's link by the link of the linked room, which halves the number of links between
// the room and the end of its chain. One invocation per word of 32 cells.
#include "cave/trees.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  for (uint starts = openStarts(i); starts != 0u; starts &= starts - 1u) {
    uint tree = uint(32 * i + findLSB(starts));
    if (isRoom(tree)) links[tree] = links[links[tree]];
  }
}

// Pointer jumping: replaces each room's link by the link of the linked room, which halves the distance to the tree that
// remains. One invocation per word of cells.
#include "cave/trees.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  for (uint starts = openStarts(i); starts != 0u; starts &= starts - 1u) {
    uint tree = uint(32 * i + findLSB(starts));
    if (isRoom(tree)) links[tree] = links[links[tree]];
  }
}

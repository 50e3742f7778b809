// Links each tree to the tree at the other end of its shortest connection. If two trees choose the same connection, the
// lower tree remains. One invocation per word of cells.
#include "cave/trees.glsl"

uint treeAt(uint cell) {
  return trees[labels[runOf(sources[cell])]];
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  for (uint starts = openStarts(i); starts != 0u; starts &= starts - 1u) {
    uint tree = uint(32 * i + findLSB(starts));
    if (!isRoom(tree)) continue;
    links[tree] = tree;
    uint edge = edges[tree];
    if (trees[tree] != tree || edge == nowhere) continue;
    uint first = treeAt(edge >> 1u), second = treeAt((edge >> 1u) + ((edge & 1u) == 0u ? 1u : 32u * uint(rowWords)));
    uint other = first == tree ? second : first;
    joined = 1u;
    links[tree] = edges[other] == edge && tree < other ? tree : other;
  }
}

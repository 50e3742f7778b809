// Trees of boxes. They are complete binary trees: the root is node 1, and node i has the children 2 i and 2 i + 1.
// Compiles as GLSL and as C++, after model.glsl.

FUNCTION Hull together(Hull a, Hull b) {
  Hull hull;
  hull.low = min(a.low, b.low);
  hull.high = max(a.high, b.high);
  return hull;
}
// Returns true if the vertex is a corner of the leaf. The leaf of an edge holds the second vertex also as the third.
FUNCTION bool isCornerOf(uvec4 leaf, uint vertex) {
  return leaf.x == vertex || leaf.y == vertex || leaf.z == vertex;
}
// Returns the node that follows the subtree of `node` in preorder, or 0 if none follows.
FUNCTION int nodeAfter(int node) {
  int next = node + 1;
  for (int k = 0; k < 5; ++k) {  // Goes up from `node` while the node is a right child, by removing the trailing zero
                                 // bits of node + 1.
    int steps = 16 >> k;
    next = (next & ((1 << steps) - 1)) == 0 ? next >> steps : next;
  }
  return next == 1 ? 0 : next;
}
// Returns the node index of the last leaf below a node.
FUNCTION int lastLeaf(int node, int levels) {
  int depth = 0, at = node;
  for (int k = 0; k < 5; ++k) {
    int steps = 16 >> k;
    bool deep = (at >> steps) != 0;
    depth = deep ? depth + steps : depth;
    at = deep ? at >> steps : at;
  }
  return ((node + 1) << (levels - depth)) - 1;
}

// Trees of boxes: binary and complete, node i over nodes 2 i and 2 i + 1, the root 1. Compiles as GLSL and as C++, after
// model.glsl.

FUNCTION Hull together(Hull a, Hull b) {
  Hull hull;
  hull.low = min(a.low, b.low);
  hull.high = max(a.high, b.high);
  return hull;
}
// Of a face, or an edge, whose third corner is its second.
FUNCTION bool isCornerOf(uvec4 leaf, uint vertex) {
  return leaf.x == vertex || leaf.y == vertex || leaf.z == vertex;
}
// The node after `node` and all that is below it, in the order in which parents come first; 0: it was the last.
FUNCTION int nodeAfter(int node) {
  int next = node + 1;
  for (int k = 0; k < 5; ++k) {  // up from second children, by powers of two
    int steps = 16 >> k;
    next = (next & ((1 << steps) - 1)) == 0 ? next >> steps : next;
  }
  return next == 1 ? 0 : next;
}
// The last leaf below a node, as a node.
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

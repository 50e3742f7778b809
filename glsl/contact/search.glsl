// Which features may come near each other. Compiles as GLSL and as C++, after model.glsl.

FUNCTION Hull together(Hull a, Hull b) {
  Hull hull;
  hull.low = min(a.low, b.low);
  hull.high = max(a.high, b.high);
  return hull;
}
FUNCTION Hull widened(Hull a, float by) {
  precise vec3 low = a.low - by;
  precise vec3 high = a.high + by;
  Hull hull;
  hull.low = low;
  hull.high = high;
  return hull;
}
FUNCTION bool ownsVertex(uvec4 leaf, int k) {
  return ((leaf.w >> uint(k)) & 1u) == 1u;
}
FUNCTION bool ownsEdge(uvec4 leaf, int k) {
  return ((leaf.w >> uint(k + 3)) & 1u) == 1u;
}
FUNCTION bool hasNoFace(uvec4 leaf) {
  return (leaf.w >> 31u) == 1u;
}
FUNCTION bool hasCorner(uvec4 leaf, uint vertex) {
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
// Whether all leaves of a node come before the one whose node is `leaf`, or are it.
FUNCTION bool comesBefore(int node, int leaf, int levels) {
  int depth = 0, at = node;
  for (int k = 0; k < 5; ++k) {
    int steps = 16 >> k;
    bool deep = (at >> steps) != 0;
    depth = deep ? depth + steps : depth;
    at = deep ? at >> steps : at;
  }
  int down = levels - depth;
  return ((node + 1) << down) - 1 <= leaf;
}

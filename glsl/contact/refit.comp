// Computes the boxes of AT_ONCE consecutive levels of a tree from the level below them; `level` is the topmost level
// that it computes.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(boxesBinding, BoxBlock, boxes)
uniform int level;
uniform int levels;

Hull boxBelow(int node) {
  return Hull(LOAD_ONCE(boxes, 2 * node).xyz, LOAD_ONCE(boxes, 2 * node + 1).xyz);
}
Hull kept(int node, Hull a, Hull b) {
  Hull box = together(a, b);
  STORE_STATE(boxes, 2 * node, vec4(box.low, intBitsToFloat(nodeAfter(node))));
  STORE_STATE(boxes, 2 * node + 1, vec4(box.high, intBitsToFloat(lastLeaf(node, levels))));
  return box;
}
Hull fitted1(int node) {
  return kept(node, boxBelow(2 * node), boxBelow(2 * node + 1));
}
Hull fitted2(int node) {
  return kept(node, fitted1(2 * node), fitted1(2 * node + 1));
}
Hull fitted3(int node) {
  return kept(node, fitted2(2 * node), fitted2(2 * node + 1));
}

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << level;
  if (i >= count) return;
#if AT_ONCE == 3
  fitted3(count + i);
#elif AT_ONCE == 2
  fitted2(count + i);
#else
  fitted1(count + i);
#endif
}

// Computes the boxes of faces or edges: all possible positions of their corners, enlarged by half the thickness. The w
// components hold integers as float bits: in the low corner the next node if the node's subtree is skipped, in the high
// corner the last leaf of the subtree.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(leavesBinding, LeafBlock, leaves)
layout(std430, binding = boxesBinding) restrict writeonly buffer BoxBlock { vec4 boxes[]; };
uniform int levels;

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << levels;
  if (i >= count) return;
  uvec4 leaf = LOAD_INPUT_WORDS(leaves, i);
  Hull box = together(together(hullOf(leaf.x), hullOf(leaf.y)), hullOf(leaf.z));
  bool none = leaf.w != 0u;  // An empty leaf: its inverted box overlaps nothing and does not enlarge its ancestors.
  int node = count + i;
  boxes[2 * node] = vec4(none ? vec3(1e30f) : box.low, intBitsToFloat(nodeAfter(node)));
  boxes[2 * node + 1] = vec4(none ? vec3(-1e30f) : box.high, intBitsToFloat(node));
}

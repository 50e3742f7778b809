// Computes the boxes of faces or edges, one invocation per leaf. A box covers all possible positions of the corners,
// enlarged by half the thickness. The w components hold integers as float bits: in the minimum corner, the node at
// which a traversal continues if it skips the node's subtree; in the maximum corner, the last leaf of the subtree.
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
  bool none = leaf.w != 0u;  // The box of an empty leaf is inverted, so that it overlaps nothing and does not enlarge
                             // its ancestors.
  int node = count + i;
  boxes[2 * node] = vec4(none ? vec3(1e30f) : box.low, intBitsToFloat(nodeAfter(node)));
  boxes[2 * node + 1] = vec4(none ? vec3(-1e30f) : box.high, intBitsToFloat(node));
}

// Boxes of faces or edges: of all places where their corners may be, and half the thickness around. In w, as bits: of the low
// corner the node to go on with when nothing below this one is wanted, of the high one the last leaf below it.
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
  bool none = leaf.w != 0u;  // its box overlaps nothing, and adds nothing to what is above it
  int node = count + i;
  boxes[2 * node] = vec4(none ? vec3(1e30f) : box.low, intBitsToFloat(nodeAfter(node)));
  boxes[2 * node + 1] = vec4(none ? vec3(-1e30f) : box.high, intBitsToFloat(node));
}

// Boxes of a level of the tree from those below.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(boxesBinding, BoxBlock, boxes)
uniform int level;
uniform int levels;

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << level;
  if (i >= count) return;
  int node = count + i;
  vec3 low = min(LOAD_ONCE(boxes, 4 * node).xyz, LOAD_ONCE(boxes, 4 * node + 2).xyz);
  vec3 high = max(LOAD_ONCE(boxes, 4 * node + 1).xyz, LOAD_ONCE(boxes, 4 * node + 3).xyz);
  STORE_STATE(boxes, 2 * node, vec4(low, intBitsToFloat(nodeAfter(node))));
  STORE_STATE(boxes, 2 * node + 1, vec4(high, intBitsToFloat(lastLeaf(node, levels))));
}

// Boxes of a level of the tree from those below.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(boxesBinding, BoxBlock, boxes)
uniform int level;

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << level;
  if (i >= count) return;
  int node = count + i;
  STORE_STATE(boxes, 2 * node, min(LOAD_ONCE(boxes, 4 * node), LOAD_ONCE(boxes, 4 * node + 2)));
  STORE_STATE(boxes, 2 * node + 1, max(LOAD_ONCE(boxes, 4 * node + 1), LOAD_ONCE(boxes, 4 * node + 3)));
}

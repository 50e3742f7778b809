// Builds one level of tree nodes: leaves from their bodies (if LEAVES is defined), or parents from their two children,
// the left child first. The levels are built from the leaves upwards, one dispatch per level, so no node waits for
// another. One invocation per node.
#define REAL float
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(bodiesBinding, BodyBlock, bodies)
STATE_ARRAY(boxesBinding, BoxBlock, boxes)
STATE_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(momentsBinding, MomentBlock, moments)
uniform int roots;
uniform int width;  // Number of nodes of this level in each tree
uniform float perOpening;

vec4 loadBody(int i) {
  return LOAD_INPUT(bodies, i);
}
#include "particles/tree/model.glsl"

Node loadNode(int i) {
  return unpackNode(LOAD_ONCE(boxes, 2 * i), LOAD_ONCE(boxes, 2 * i + 1), LOAD_ONCE(cells, i),
                    LOAD_ONCE(moments, 2 * i), LOAD_ONCE(moments, 2 * i + 1));
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= roots * width) return;
  int base = i / width * rootNodes;
  int at = width + i % width;
#ifdef LEAVES
  Node node = leafNode(i * leafBodies);
#else
  Node node = parentNode(loadNode(base + 2 * at), loadNode(base + 2 * at + 1));
#endif
  int to = base + at;
  STORE_STATE(boxes, 2 * to, vec4(node.low, 0.0f));
  STORE_STATE(boxes, 2 * to + 1, vec4(node.high, 0.0f));
  STORE_STATE(cells, to, nodeCell(node, perOpening));
  STORE_STATE(moments, 2 * to, nodeMoments0(node));
  STORE_STATE(moments, 2 * to + 1, nodeMoments1(node));
}

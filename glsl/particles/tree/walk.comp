// Computes the forces on all bodies by walking the trees depth first. The bodies of a group walk together: a node far
// from the group's box acts through its moments, and a near node is opened. Every invocation of a group takes the same
// path, so loads serve all invocations, and each body's sum has the same order on every device. The walk needs no
// shared memory, barriers or stack, because the next node follows from the index of the last node. Whatever the
// positions are, a tree takes at most 8191 node visits and 32768 bodies.
//
// An invocation processes eight bodies with the same loads and tests. This kernel is for the texel path; walk_list.comp
// is for storage buffers.
#define LANES 4
#define REAL vec4
#define LANE(v, k) v[k]
layout(local_size_x = 32) in;
#include "common/exact.glsl"
EXACT_INVERSE_SQRT(REAL)
#include "common/memory.glsl"
#include "common/words.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
INPUT_ARRAY(bodiesBinding, BodyBlock, bodies)
INPUT_ARRAY(boxesBinding, BoxBlock, boxes)
INPUT_ARRAY(cellsBinding, CellBlock, cells)
INPUT_ARRAY(momentsBinding, MomentBlock, moments)
INPUT_WORDS(recordsBinding, RecordBlock, records)
STATE_ARRAY(accelerationsBinding, AccelerationBlock, accelerations)
uniform int count;
uniform int firstRoot;  // First tree of this dispatch; partial sums are stored in memory between dispatches
uniform int lastRoot;
uniform bool finish;
uniform float gravity;
uniform float softening2;

vec4 loadBody(int i) {
  return LOAD_INPUT(bodies, i);
}
#include "particles/tree/model.glsl"

// Positions of several bodies, one body per component of REAL, and the sums of the pulls on them so far.
struct Bodies {
  REAL x;
  REAL y;
  REAL z;
  Pull sum;
};

Bodies fetch(int first) {
  Bodies result;
  for (int k = 0; k < LANES; ++k) {
    vec4 body = loadBody(first + k);
    LANE(result.x, k) = body.x;
    LANE(result.y, k) = body.y;
    LANE(result.z, k) = body.z;
    vec4 before = vec4(0.0f);
    if (firstRoot > 0 && first + k < count)
      before = LOAD_STATE(accelerations, int(LOAD_INPUT_WORDS(records, first + k).z));
    LANE(result.sum.x, k) = before.x;
    LANE(result.sum.y, k) = before.y;
    LANE(result.sum.z, k) = before.z;
  }
  return result;
}

void store(int first, Pull sum) {
  for (int k = 0; k < LANES; ++k) {
    if (first + k >= count) return;
    vec3 total = vec3(LANE(sum.x, k), LANE(sum.y, k), LANE(sum.z, k));
    precise vec3 scaled = total * gravity;
    vec3 result = finish ? flushed(scaled) : total;
    bool takes = loadBody(first + k).w > 0.0f;
    int index = int(LOAD_INPUT_WORDS(records, first + k).z);
    STORE_STATE(accelerations, index, vec4(takes ? result : vec3(0.0f), 0.0f));
  }
}

void main() {
  int first = int(gl_GlobalInvocationID.x) * 2 * LANES;
  if (first >= count) return;
  Bodies a = fetch(first);
  Bodies b = fetch(first + LANES);
  int group = first / groupBodies;
  const int groupsOfRoot = rootBodies / groupBodies;
  int box = group / groupsOfRoot * rootNodes + groupsOfRoot + group % groupsOfRoot;
  vec3 low = LOAD_INPUT(boxes, 2 * box).xyz;
  vec3 high = LOAD_INPUT(boxes, 2 * box + 1).xyz;
  precise vec3 middle = (high - low) * 0.5f + low;
  precise vec3 above = high - middle;
  precise vec3 below = middle - low;
  vec3 halfSize = max(above, below);
  // All trees are processed in order; a group without bodies skips them.
  int last = low.x <= high.x ? lastRoot : firstRoot;
  for (int root = firstRoot; root < last; ++root) {
    int node = 1;
    do {
      int at = root * rootNodes + node;
      vec4 cell = LOAD_INPUT(cells, at);
      if (isFar(cell, middle, halfSize)) {
        vec4 moments0 = LOAD_INPUT(moments, 2 * at);
        vec4 moments1 = LOAD_INPUT(moments, 2 * at + 1);
        a.sum = plusNode(a.sum, a.x, a.y, a.z, cell.xyz, moments0, moments1, softening2);
        b.sum = plusNode(b.sum, b.x, b.y, b.z, cell.xyz, moments0, moments1, softening2);
        node = nodeAfter(node);
      } else if (node >= rootLeaves) {
        int body = root * rootBodies + (node - rootLeaves) * leafBodies;
        for (int end = body + leafBodies; body < end; ++body) {
          vec4 other = loadBody(body);
          a.sum = plusBody(a.sum, a.x, a.y, a.z, other, softening2);
          b.sum = plusBody(b.sum, b.x, b.y, b.z, other, softening2);
        }
        node = nodeAfter(node);
      } else {
        node = 2 * node;
      }
    } while (node != 1);
  }
  store(first, a.sum);
  store(first + LANES, b.sum);
}

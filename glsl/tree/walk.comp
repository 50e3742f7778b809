// Forces on all bodies. The bodies of a group walk the trees together, depth first: what is far from the group's
// box pulls by its moments, what is near is opened. Every invocation of a group takes the same way, so loads
// are shared and the order of a body's sum is the same on every device. Without shared memory, barriers or a
// stack: the next node follows from the number of the last. A tree is walked in at most 8191 visits and
// 32768 bodies, whatever the positions are.
#ifdef TEXEL_PATH
#define LANES 4  // bodies an invocation carries: loads cost more than arithmetic there
#define REAL vec4
#else
#define LANES 2
#define REAL vec2
#endif
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "tree/types.glsl"
layout(local_size_x = 128) in;
INPUT_ARRAY(0, BodyBlock, bodies)
INPUT_ARRAY(1, BoxBlock, boxes)
INPUT_ARRAY(2, CellBlock, cells)
INPUT_ARRAY(3, MomentBlock, moments)
INPUT_WORDS(4, RecordBlock, records)
STATE_ARRAY(5, AccelerationBlock, accelerations)
uniform int count;
uniform int firstRoot;  // the trees of this dispatch; sums pass from one to the next in memory
uniform int lastRoot;
uniform bool finish;
uniform float gravity;
uniform float softening2;

vec4 loadBody(int i) {
  return LOAD_INPUT(bodies, i);
}
#include "tree/model.glsl"

Pull walkTree(int root, vec3 middle, vec3 halfSize, REAL x, REAL y, REAL z, Pull pull) {
  Pull sum = pull;
  int node = 1;
  do {
    int at = root * rootNodes + node;
    vec4 cell = LOAD_INPUT(cells, at);
    if (isFar(cell, middle, halfSize)) {
      sum = plusNode(sum, x, y, z, cell.xyz, LOAD_INPUT(moments, 2 * at), LOAD_INPUT(moments, 2 * at + 1),
                     softening2);
      node = nodeAfter(node);
    } else if (node >= rootLeaves) {
      int first = root * rootBodies + (node - rootLeaves) * leafBodies;
      for (int i = 0; i < leafBodies; ++i) sum = plusBody(sum, x, y, z, loadBody(first + i), softening2);
      node = nodeAfter(node);
    } else {
      node = 2 * node;
    }
  } while (node != 1);
  return sum;
}

void store(int i, int index, bool takes, vec3 sum) {
  if (i >= count) return;
  precise vec3 scaled = sum * gravity;
  vec3 result = finish ? flushed(scaled) : sum;
  STORE_STATE(accelerations, index, vec4(takes ? result : vec3(0.0f), 0.0f));
}

void main() {
  int first = int(gl_GlobalInvocationID.x) * LANES;
  if (first >= count) return;
  REAL x, y, z;
  bool takes[LANES];
  int index[LANES];
  Pull sum;
  sum.x = REAL(0.0f);
  sum.y = REAL(0.0f);
  sum.z = REAL(0.0f);
  for (int k = 0; k < LANES; ++k) {
    vec4 body = loadBody(first + k);
    x[k] = body.x;
    y[k] = body.y;
    z[k] = body.z;
    takes[k] = body.w > 0.0f;
    index[k] = first + k < count ? int(LOAD_INPUT_WORDS(records, first + k).z) : 0;
    if (firstRoot > 0 && first + k < count) {
      vec4 before = LOAD_STATE(accelerations, index[k]);
      sum.x[k] = before.x;
      sum.y[k] = before.y;
      sum.z[k] = before.z;
    }
  }
  int group = first / groupBodies;
  const int perRoot = rootBodies / groupBodies;
  int box = group / perRoot * rootNodes + perRoot + group % perRoot;
  vec3 low = LOAD_INPUT(boxes, 2 * box).xyz;
  vec3 high = LOAD_INPUT(boxes, 2 * box + 1).xyz;
  if (low.x <= high.x) {
    precise vec3 middle = high - low;
    middle = middle * 0.5f;
    middle = middle + low;
    precise vec3 above = high - middle;
    precise vec3 below = middle - low;
    vec3 halfSize = max(above, below);
    for (int root = firstRoot; root < lastRoot; ++root)
      sum = walkTree(root, middle, halfSize, x, y, z, sum);
  }
  for (int k = 0; k < LANES; ++k)
    store(first + k, index[k], takes[k], vec3(sum.x[k], sum.y[k], sum.z[k]));
}

// Variant of walk.comp for storage buffers, used on GPUs. It computes the same sums in the same order, but without a
// long chain of dependent node visits. A workgroup processes the bodies of a group, one body per invocation. In each
// round, the invocations together test up to 64 nodes: those that come next in the depth-first walk. A near node is
// replaced by its two children. A far node or a near leaf is settled. The settled nodes before the first unsettled one
// are moved to the list `ready`, which is processed 64 entries at a time. A REAL holds four sources, whose pulls on a
// body are computed in parallel and added in order.
//
// The shared memory is small, because a driver may limit all workgroups of a multiprocessor together to 48 KiB or less.
#define REAL vec4
#include "common/exact.glsl"
EXACT_INVERSE_SQRT(REAL)
#include "common/memory.glsl"
#include "common/words.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = groupBodies) in;
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

// An entry is root * rootNodes + node, plus flags for the result of its test.
const uint settled = 0x80000000u;
const uint opened = 0x40000000u;  // Flag of a near leaf, whose bodies act one by one
const uint placeBits = 0x3fffffffu;

const int capacity = 512;
shared uint waiting[capacity];     // Stack, whose top entry comes next in the walk
shared uint ready[2 * groupBodies];
shared uint divided[2];            // Bit mask of the current entries that are replaced by their children
shared vec4 staged[3][groupBodies];

vec4 loadBody(int i) {
  return LOAD_INPUT(bodies, i);
}
#include "particles/tree/model.glsl"

vec3 plusFour(vec3 sum, Pull p, int many) {
  precise vec3 one = sum + vec3(p.x.x, p.y.x, p.z.x);
  precise vec3 two = one + vec3(p.x.y, p.y.y, p.z.y);
  precise vec3 three = two + vec3(p.x.z, p.y.z, p.z.z);
  precise vec3 four = three + vec3(p.x.w, p.y.w, p.z.w);
  return many == 4 ? four : many == 3 ? three : many == 2 ? two : one;
}

vec3 plusBodies(vec3 sum, vec3 at, int first) {
  vec4 a = loadBody(first), b = loadBody(first + 1), c = loadBody(first + 2), d = loadBody(first + 3);
  precise vec4 dx = vec4(a.x, b.x, c.x, d.x) - at.x;
  precise vec4 dy = vec4(a.y, b.y, c.y, d.y) - at.y;
  precise vec4 dz = vec4(a.z, b.z, c.z, d.z) - at.z;
  return plusFour(sum, bodyPull(dx, dy, dz, vec4(a.w, b.w, c.w, d.w), softening2), 4);
}

// Returns `sum` plus the pulls of the nodes in entries k to k + many - 1, where `many` is at most four.
vec3 plusNodes(vec3 sum, vec3 at, int k, int many) {
  int k1 = k + min(1, many - 1), k2 = k + min(2, many - 1), k3 = k + many - 1;
  vec4 a = staged[0][k], b = staged[0][k1], c = staged[0][k2], d = staged[0][k3];
  precise vec4 dx = vec4(a.x, b.x, c.x, d.x) - at.x;
  precise vec4 dy = vec4(a.y, b.y, c.y, d.y) - at.y;
  precise vec4 dz = vec4(a.z, b.z, c.z, d.z) - at.z;
  vec4 a0 = staged[1][k], b0 = staged[1][k1], c0 = staged[1][k2], d0 = staged[1][k3];
  vec4 a1 = staged[2][k], b1 = staged[2][k1], c1 = staged[2][k2], d1 = staged[2][k3];
  Moments m = Moments(vec4(a0.x, b0.x, c0.x, d0.x), vec4(a0.y, b0.y, c0.y, d0.y), vec4(a0.z, b0.z, c0.z, d0.z),
                      vec4(a0.w, b0.w, c0.w, d0.w), vec4(a1.x, b1.x, c1.x, d1.x), vec4(a1.y, b1.y, c1.y, d1.y),
                      vec4(a1.z, b1.z, c1.z, d1.z), vec4(a1.w, b1.w, c1.w, d1.w));
  return plusFour(sum, nodePull(dx, dy, dz, m, softening2), many);
}

// Returns `sum` plus the pulls of the first `many` entries of `ready`.
vec3 plusReady(vec3 sum, vec3 at, int thread, int many) {
  uint mine = ready[thread];
  if (thread < many && (mine & opened) == 0u) {
    int place = int(mine & placeBits);
    staged[0][thread] = LOAD_INPUT(cells, place);
    staged[1][thread] = LOAD_INPUT(moments, 2 * place);
    staged[2][thread] = LOAD_INPUT(moments, 2 * place + 1);
  }
  barrier();
  for (int k = 0; k < many;) {
    uint entry = ready[k];
    int nodes = 1;
    if ((entry & opened) != 0u) {
      int place = int(entry & placeBits);
      int first = place / rootNodes * rootBodies + (place % rootNodes - rootLeaves) * leafBodies;
      sum = plusBodies(sum, at, first);
      sum = plusBodies(sum, at, first + 4);
    } else {
      if (k + 1 < many && (ready[k + 1] & opened) == 0u) nodes = 2;
      if (nodes == 2 && k + 2 < many && (ready[k + 2] & opened) == 0u) nodes = 3;
      if (nodes == 3 && k + 3 < many && (ready[k + 3] & opened) == 0u) nodes = 4;
      sum = plusNodes(sum, at, k, nodes);
    }
    k += nodes;
  }
  barrier();
  return sum;
}

// Returns the number of bits set below `bit`.
int dividedBelow(uvec2 bits, int bit) {
  uint low = bit < 32 ? bits.x & ((1u << uint(bit)) - 1u) : bits.x;
  uint high = bit < 32 ? 0u : bits.y & ((1u << uint(bit - 32)) - 1u);
  return bitCount(low) + bitCount(high);
}

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int group = int(gl_WorkGroupID.x);
  int mine = group * groupBodies + thread;
  vec4 body = loadBody(mine);
  int index = mine < count ? int(LOAD_INPUT_WORDS(records, mine).z) : 0;
  vec4 earlier = vec4(0.0f);
  if (firstRoot > 0 && mine < count) earlier = LOAD_STATE(accelerations, index);
  vec3 sum = earlier.xyz;
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
  int readyCount = 0;
  if (thread < 2) divided[thread] = 0u;
  for (int root = firstRoot; root < last; root += groupBodies) {
    int size = min(last - root, groupBodies);
    if (thread < size) waiting[size - 1 - thread] = uint((root + thread) * rootNodes + 1);
    barrier();
    while (size > 0) {
      int taken = min(size, groupBodies);
      uint entry = settled;
      if (thread < taken) entry = waiting[size - 1 - thread];
      // If the stack has no room for 64 more entries, only one entry at a time is divided, because a depth-first walk
      // needs at most 12 more entries.
      bool may = size + groupBodies + 12 <= capacity;
      if ((entry & settled) == 0u) {
        bool far = isFar(LOAD_INPUT(cells, int(entry)), middle, halfSize);
        if (far || int(entry) % rootNodes >= rootLeaves)
          entry |= far ? settled : settled | opened;
        else
          atomicOr(divided[thread / 32], 1u << uint(thread % 32));
      }
      barrier();
      uvec2 bits = uvec2(divided[0], divided[1]);
      int first = bits.x != 0u ? findLSB(bits.x) : bits.y != 0u ? 32 + findLSB(bits.y) : taken;
      if (!may) bits = first < 32 ? uvec2(bits.x & (1u << uint(first)), 0u) : uvec2(0u, bits.y & (1u << uint(first - 32)));
      int kept = taken - first + bitCount(bits.x) + bitCount(bits.y);
      if (thread < first) {
        ready[readyCount + thread] = entry;
      } else if (thread < taken) {
        int order = thread - first + dividedBelow(bits, thread);
        int to = size - taken + kept - 1 - order;
        bool divides = ((thread < 32 ? bits.x : bits.y) >> uint(thread % 32) & 1u) != 0u;
        waiting[to] = divides ? 2u * entry - entry / uint(rootNodes) * uint(rootNodes) : entry;
        if (divides) waiting[to - 1] = waiting[to] + 1u;
      }
      size += kept - taken;
      readyCount += first;
      barrier();
      if (thread < 2) divided[thread] = 0u;
      if (readyCount >= groupBodies) {
        sum = plusReady(sum, body.xyz, thread, groupBodies);
        readyCount -= groupBodies;
        if (thread < readyCount) ready[thread] = ready[groupBodies + thread];
      }
      barrier();
    }
  }
  sum = plusReady(sum, body.xyz, thread, readyCount);
  if (mine >= count) return;
  precise vec3 scaled = sum * gravity;
  vec3 result = finish ? flushed(scaled) : sum;
  STORE_STATE(accelerations, index, vec4(body.w > 0.0f ? result : vec3(0.0f), 0.0f));
}

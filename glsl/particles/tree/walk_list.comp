// walk.comp for storage blocks, and so for graphics cards: the same sums in the same order, without a long chain of
// visits that wait for one another. A work group takes the bodies of a group, one an invocation, and first lists what
// pulls them: from the list {half of a tree}, every near node is replaced by its two children in its place, level by level, all
// nodes of the list at once. That leaves the far nodes and the near leaves in the order of a walk depth first. Then all
// go through the list, 64 entries at a time from shared memory, four far nodes in flight where four follow each other.
// The halves of a tree one after the other, so that lists fit into shared memory.
#define REAL float
#include "common/exact.glsl"
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
uniform int firstRoot;  // the trees of this dispatch; sums pass from one to the next in memory
uniform int lastRoot;
uniform bool finish;
uniform float gravity;
uniform float softening2;

const uint settled = 0x8000u;  // of an entry: it stays
const uint opened = 0x4000u;   // a leaf whose bodies pull one by one
const uint nodeBits = 0x3fffu;

shared uint entries[2][rootLeaves / 2];  // no node stands above another in a list, so none is longer than all leaves
shared int before[groupBodies];      // entries that the invocations up to this one write
shared vec4 staged[groupBodies * leafBodies];

vec4 loadBody(int i) {
  return LOAD_INPUT(bodies, i);
}
#include "particles/tree/model.glsl"

// The inclusive sum of `value` over the invocations up to this one.
int sumUpTo(int thread, int value) {
  before[thread] = value;
  barrier();
  for (int reach = 1; reach < groupBodies; reach *= 2) {
    int lower = thread >= reach ? before[thread - reach] : 0;
    barrier();
    before[thread] += lower;
    barrier();
  }
  return before[thread];
}

// Lists what of the nodes below `top`, 2 or 3, pulls the box, in one of the two `entries`; x: which, y: how many. A
// tree that is far as a whole is all of the first list.
ivec2 list(int thread, int root, int top, vec3 middle, vec3 halfSize) {
  int half_ = 0;
  int length_ = 1;
  bool whole = isFar(LOAD_INPUT(cells, root * rootNodes + 1), middle, halfSize);
  if (whole && top == 3) return ivec2(0, 0);
  barrier();
  if (thread == 0) entries[0][0] = whole ? 1u | settled : uint(top);
  barrier();
  for (int level = 2; level <= rootLeaves; level *= 2) {
    int share = (length_ - 1) / groupBodies + 1;
    int first = min(thread * share, length_);
    int last = min(first + share, length_);
    int places = last - first;
    for (int i = first; i < last; ++i) {
      uint entry = entries[half_][i];
      if ((entry & settled) == 0u) {
        int node = int(entry);
        bool far = isFar(LOAD_INPUT(cells, root * rootNodes + node), middle, halfSize);
        if (far || node >= rootLeaves)
          entries[half_][i] = entry | (far ? settled : settled | opened);
        else
          ++places;
      }
    }
    int next = sumUpTo(thread, places) - places;
    int total = before[groupBodies - 1];
    if (total == length_) break;
    for (int i = first; i < last; ++i) {
      uint entry = entries[half_][i];
      bool stays = (entry & settled) != 0u;
      entries[1 - half_][next] = stays ? entry : 2u * entry;
      ++next;
      if (!stays) {
        entries[1 - half_][next] = 2u * entry + 1u;
        ++next;
      }
    }
    barrier();
    half_ = 1 - half_;
    length_ = total;
  }
  return ivec2(half_, length_);
}

// What entry `thread` of a chunk needs: a node's centre and moments, or a leaf's bodies.
void stage(int thread, int root, uint entry) {
  int to = thread * leafBodies;
  int node = int(entry & nodeBits);
  if ((entry & opened) != 0u) {
    int body = root * rootBodies + (node - rootLeaves) * leafBodies;
    for (int k = 0; k < leafBodies; ++k) staged[to + k] = loadBody(body + k);
  } else {
    int at = root * rootNodes + node;
    staged[to] = LOAD_INPUT(cells, at);
    staged[to + 1] = LOAD_INPUT(moments, 2 * at);
    staged[to + 2] = LOAD_INPUT(moments, 2 * at + 1);
  }
}

Pull plusStagedNode(Pull sum, vec3 at, int k) {
  int from = k * leafBodies;
  return plusNode(sum, at.x, at.y, at.z, staged[from].xyz, staged[from + 1], staged[from + 2], softening2);
}

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int group = int(gl_WorkGroupID.x);
  int mine = group * groupBodies + thread;
  vec4 body = loadBody(mine);
  int index = mine < count ? int(LOAD_INPUT_WORDS(records, mine).z) : 0;
  vec4 earlier = vec4(0.0f);
  if (firstRoot > 0 && mine < count) earlier = LOAD_STATE(accelerations, index);
  Pull sum;
  sum.x = earlier.x;
  sum.y = earlier.y;
  sum.z = earlier.z;
  const int groupsOfRoot = rootBodies / groupBodies;
  int box = group / groupsOfRoot * rootNodes + groupsOfRoot + group % groupsOfRoot;
  vec3 low = LOAD_INPUT(boxes, 2 * box).xyz;
  vec3 high = LOAD_INPUT(boxes, 2 * box + 1).xyz;
  precise vec3 middle = (high - low) * 0.5f + low;
  precise vec3 above = high - middle;
  precise vec3 below = middle - low;
  vec3 halfSize = max(above, below);
  // The trees one after the other; a group without bodies walks none.
  int last = low.x <= high.x ? lastRoot : firstRoot;
  for (int part = 2 * firstRoot; part < 2 * last; ++part) {
    int root = part / 2;
    ivec2 listed = list(thread, root, 2 + part % 2, middle, halfSize);
    for (int chunk = 0; chunk < listed.y; chunk += groupBodies) {
      int length_ = min(listed.y - chunk, groupBodies);
      if (thread < length_) stage(thread, root, entries[listed.x][chunk + thread]);
      barrier();
      for (int k = 0; k < length_;) {
        uint kinds = entries[listed.x][chunk + k];
        if (k + 3 < length_)
          kinds |= entries[listed.x][chunk + k + 1] | entries[listed.x][chunk + k + 2] | entries[listed.x][chunk + k + 3];
        if (k + 3 < length_ && (kinds & opened) == 0u) {
          sum = plusStagedNode(sum, body.xyz, k);
          sum = plusStagedNode(sum, body.xyz, k + 1);
          sum = plusStagedNode(sum, body.xyz, k + 2);
          sum = plusStagedNode(sum, body.xyz, k + 3);
          k += 4;
        } else {
          if ((entries[listed.x][chunk + k] & opened) != 0u) {
            for (int i = 0; i < leafBodies; ++i)
              sum = plusBody(sum, body.x, body.y, body.z, staged[k * leafBodies + i], softening2);
          } else {
            sum = plusStagedNode(sum, body.xyz, k);
          }
          ++k;
        }
      }
      barrier();
    }
  }
  if (mine >= count) return;
  vec3 total = vec3(sum.x, sum.y, sum.z);
  precise vec3 scaled = total * gravity;
  vec3 result = finish ? flushed(scaled) : total;
  STORE_STATE(accelerations, index, vec4(body.w > 0.0f ? result : vec3(0.0f), 0.0f));
}

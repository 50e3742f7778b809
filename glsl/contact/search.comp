// Pairs of features whose boxes overlap, by a walk through the tree of boxes from each face. Each pair is found once: by the
// faces that look after its features, from the one that comes first.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(leavesBinding, LeafBlock, leaves)
INPUT_ARRAY(boxesBinding, BoxBlock, boxes)
layout(std430, binding = pairsBinding) restrict writeonly buffer PairBlock { ivec4 pairs[]; };

Hull hullOf(uint vertex) {
  int v = int(vertex);
  Hull hull;
  hull.low = pointAt(lowSection, v).xyz;
  hull.high = pointAt(highSection, v).xyz;
  return widened(hull, pointAt(nextSection, v).w);
}

const int maxVisited = 60000;  // a software driver's loops end at 65,535

void keepPair(int kind, uvec4 corners) {
  uint place = atomicAdd(control.pairCounts[kind], 1u);
  if (place < uint(contactStep.maxPairs)) pairs[kind * contactStep.maxPairs + int(place)] = ivec4(corners);
}

void verticesWithFace(uvec4 mine, uvec4 other, vec3 low, vec3 high) {
  for (int k = 0; k < 3; ++k) {
    uint v = mine[k];
    if (!ownsVertex(mine, k) || hasCorner(other, v)) continue;
    Hull hull = hullOf(v);
    if (overlap(hull.low, hull.high, low, high)) keepPair(0, uvec4(v, other.xyz));
  }
}

void edgesWithEdges(uvec4 mine, uvec4 other) {
  for (int k = 0; k < 3; ++k) {
    if (!ownsEdge(mine, k)) continue;
    uint p = mine[k], q = mine[k == 2 ? 0 : k + 1];
    Hull hull = together(hullOf(p), hullOf(q));
    for (int l = 0; l < 3; ++l) {
      uint r = other[l], s = other[l == 2 ? 0 : l + 1];
      if (!ownsEdge(other, l) || p == r || p == s || q == r || q == s) continue;
      Hull others = together(hullOf(r), hullOf(s));
      if (overlap(hull.low, hull.high, others.low, others.high)) keepPair(1, uvec4(p, q, r, s));
    }
  }
}

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << contactStep.levels;
  if (i >= count) return;
  uvec4 mine = LOAD_INPUT_WORDS(leaves, i);
  if (hasNoFace(mine)) return;
  int own = count + i;
  vec3 low = LOAD_INPUT(boxes, 2 * own).xyz, high = LOAD_INPUT(boxes, 2 * own + 1).xyz;
  int node = 1, visited = 0;
  for (; node != 0 && visited < maxVisited; ++visited) {
    vec3 otherLow = LOAD_INPUT(boxes, 2 * node).xyz, otherHigh = LOAD_INPUT(boxes, 2 * node + 1).xyz;
    bool meets = overlap(low, high, otherLow, otherHigh) && !comesBefore(node, own, contactStep.levels);
    bool leaf = node >= count;
    if (meets && leaf) {
      uvec4 other = LOAD_INPUT_WORDS(leaves, node - count);
      verticesWithFace(mine, other, otherLow, otherHigh);
      verticesWithFace(other, mine, low, high);
      edgesWithEdges(mine, other);
    }
    node = meets && !leaf ? 2 * node : nodeAfter(node);
  }
  if (node != 0) control.mostPairs = 0xffffffffu;  // no search ends early without a word
}

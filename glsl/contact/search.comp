// Finds pairs of features whose boxes overlap by traversing a tree. Without EDGES, one invocation per vertex searches
// the tree of faces. With EDGES, one invocation per edge searches the edges after it. If the scene has solids, they are
// in the second half of each tree, and pairs of two solids are skipped.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(leavesBinding, LeafBlock, leaves)
INPUT_ARRAY(boxesBinding, BoxBlock, boxes)
layout(std430, binding = candidatesBinding) restrict writeonly buffer CandidateBlock { ivec4 candidates[]; };
uniform int levels;

const int maxVisited = 60000;  // Maximum number of nodes that a search visits, because software drivers silently end a
                               // loop after 65,535 iterations per invocation

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << levels;
#ifdef EDGES
  if (i >= (hasSolids() ? count / 2 : count)) return;
  uvec4 mine = LOAD_INPUT_WORDS(leaves, i);
  int own = count + i, kind = 1;
  vec3 low = LOAD_INPUT(boxes, 2 * own).xyz, high = LOAD_INPUT(boxes, 2 * own + 1).xyz;
#else
  if (i >= contactStep.vertices) return;
  uvec4 mine = uvec4(uint(i), uint(i), 0u, 0u);
  int own = 0, kind = 0;
  Hull hull = hullOf(uint(i));
  vec3 low = hull.low, high = hull.high;
#endif
#ifdef EDGES
  int node = 1, end = 0;
#else
  bool half_ = isSolid(i) || (isBall(i) && hasSolids());  // True to search only the half of the tree with the cloths
  int node = half_ ? 2 : 1, end = half_ ? 3 : 0;
#endif
  int visited = 0;
  for (; node != end && visited < maxVisited; ++visited) {
    vec4 otherLow = LOAD_INPUT(boxes, 2 * node), otherHigh = LOAD_INPUT(boxes, 2 * node + 1);
    bool meets = overlap(low, high, otherLow.xyz, otherHigh.xyz) && floatBitsToInt(otherHigh.w) > own;
    if (meets && node >= count) {
      uvec4 other = LOAD_INPUT_WORDS(leaves, node - count);
      if (!isCornerOf(other, mine.x) && !isCornerOf(other, mine.y)) {
        uint place = atomicAdd(control.candidateCounts[kind], 1u);
        ivec4 pair = kind == 1 ? ivec4(mine.xy, other.xy) : ivec4(mine.x, other.xyz);
        if (place < uint(contactStep.maxPairs)) candidates[kind * contactStep.maxPairs + int(place)] = pair;
      }
    }
    node = meets && node < count ? 2 * node : floatBitsToInt(otherLow.w);
  }
  if (node != end) control.pairLimit = 0xffffffffu;  // Reports that the search was cut off.
}

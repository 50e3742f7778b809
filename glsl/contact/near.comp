// Collects the pairs that may touch in this substep: edge-edge if EDGES is defined, otherwise vertex-face. One
// invocation per pair.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(pairsBinding, PairBlock, pairs)
layout(std430, binding = cornersBinding) restrict writeonly buffer CornerBlock { ivec4 corners[]; };
layout(std430, binding = nearsBinding) restrict writeonly buffer NearBlock { vec4 nears[]; };
layout(std430, binding = talliesBinding) restrict buffer TallyBlock { ivec4 tallies[]; };

#include "contact/carry.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
#ifdef EDGES
  int kind = 1;
#else
  int kind = 0;
#endif
  if (i >= min(int(control.pairCounts[kind]), contactStep.maxPairs)) return;
  ivec4 c = ivec4(LOAD_INPUT_WORDS(pairs, kind * contactStep.maxPairs + i));
  vec3 now[4], rise[4];
  for (int k = 0; k < 4; ++k) {
    now[k] = pointAt(nowSection, c[k]).xyz;
    precise vec3 way = pointAt(nextSection, c[k]).xyz - now[k];
    rise[k] = way;
  }
#ifdef EDGES
  Near near = nearOfEdges(c, now[0], now[1], now[2], now[3]);
#else
  Near near = nearOfVertex(c, now[0], now[1], now[2], now[3]);
#endif
  vec4 heights = heightsOf(near, now[0], now[1], now[2], now[3]);
  vec4 rises = heightsOf(near, rise[0], rise[1], rise[2], rise[3]);
  float thick = thicknessOf(c);
  vec4 extraMoves = vec4(0.0f);
  for (int k = 0; k < 4 && hasPath(); ++k)
    extraMoves[k] = extraMoveLimit(now[k], pointAt(nextSection, c[k]).xyz, longestPath(), pointAt(highSection, c[k]).w);
  bool ball = isBall(c.x);
  if (ball && pointAt(nowSection, c.x).w == 0.0f) return;  // Skips a ball that is not alive
  if (!isNear(near, heights, rises, thick, extraMoves)) return;
  if (meetsSolid(near)) {
    bool first = isSolid(c.x);
    vec3 way = wayOfSide(near, first, rise[0], rise[1], rise[2], rise[3]);
    precise vec4 after = heights + rises;
    carryAll(c, carriesOf(near, first, heights, after, way, thick), way);
  }
  // A distance is non-negative, so its bits compare like the float.
  if (ball) atomicMin(tallies[nearestTally(c.x)].w, floatBitsToInt(near.normal.w));
  int place = int(atomicAdd(control.nearCount, 1u));
  if (place >= contactStep.maxPairs) return;
  corners[place] = near.corners;
  nears[3 * place] = near.shares;
  nears[3 * place + 1] = near.normal;
}

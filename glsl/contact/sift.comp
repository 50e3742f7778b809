// Keeps the candidate pairs that can come within a thickness of each other while their corners stay in their boxes:
// edge-edge pairs if EDGES is defined, otherwise vertex-face pairs. One invocation per candidate.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(candidatesBinding, CandidateBlock, candidates)
layout(std430, binding = pairsBinding) restrict writeonly buffer PairBlock { ivec4 pairs[]; };

float radiusAt(int v) {
  return radiusOf(pointAt(nowSection, v).xyz, pointAt(lowSection, v).xyz, pointAt(highSection, v).xyz);
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
#ifdef EDGES
  int kind = 1;
#else
  int kind = 0;
#endif
  if (i >= min(int(control.candidateCounts[kind]), contactStep.maxPairs)) return;
  ivec4 c = ivec4(LOAD_INPUT_WORDS(candidates, kind * contactStep.maxPairs + i));
  vec3 now[4];
  vec4 radii;
  for (int k = 0; k < 4; ++k) {
    now[k] = pointAt(nowSection, c[k]).xyz;
    radii[k] = radiusAt(c[k]);
  }
#ifdef EDGES
  Near near = nearOfEdges(c, now[0], now[1], now[2], now[3]);
#else
  Near near = nearOfVertex(c, now[0], now[1], now[2], now[3]);
#endif
  if (!mayMeet(near, radii, thicknessOf(c))) return;
  if (isBall(c.x)) {
    float meets = pointAt(skinSection, c.x).w;
    if (meets >= 0.0f && meets != pointAt(skinSection, c.y).w) return;
  }
  if (meetsSolid(near) || isBall(c.x))
    for (int k = 0; k < 4; ++k)
      if (!isSolid(c[k])) points[highSection * contactStep.vertices + c[k]].w = 1.0f;
  int place = int(atomicAdd(control.pairCounts[kind], 1u));
  if (place < contactStep.maxPairs) pairs[kind * contactStep.maxPairs + place] = c;
}

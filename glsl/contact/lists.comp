// Computes dispatch sizes from counters, in one invocation. Uses the candidates of a search if CANDIDATES is defined,
// the near pairs if NEAR is defined, otherwise the pairs.
#include "contact/kernel.glsl"
layout(local_size_x = 1) in;

uvec4 groupsOf(uint count) {
  control.pairLimit = max(control.pairLimit, count);
  return uvec4((min(count, uint(contactStep.maxPairs)) + 63u) / 64u, 1u, 1u, 0u);
}

void main() {
#if defined CANDIDATES
  for (int kind = 0; kind < 2; ++kind)
    control.dispatches[vertexCandidateDispatch + kind] = groupsOf(control.candidateCounts[kind]);
#elif defined NEAR
  control.dispatches[nearDispatch] = groupsOf(control.nearCount);
  bool moved = control.maxPath != 0u;
  control.dispatches[carryDispatch] = moved ? groupsOf(control.nearCount) : uvec4(0u, 1u, 1u, 0u);
  control.dispatches[startDispatch] = moved ? uvec4(uint(contactStep.vertices + 63) / 64u, 1u, 1u, 0u) : uvec4(0u, 1u, 1u, 0u);
#else
  for (int kind = 0; kind < 2; ++kind) control.dispatches[vertexPairDispatch + kind] = groupsOf(control.pairCounts[kind]);
#endif
}

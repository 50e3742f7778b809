// Sizes of dispatches from what was counted: pairs, or with NEAR what is near.
#include "contact/kernel.glsl"
layout(local_size_x = 1) in;

void main() {
#ifdef NEAR
  control.dispatches[nearDispatch] = uvec4((control.nearCount + 63u) / 64u, 1u, 1u, 0u);
#else
  for (int kind = 0; kind < 2; ++kind) {
    uint count = control.pairCounts[kind];
    control.mostPairs = max(control.mostPairs, count);
    count = min(count, uint(contactStep.maxPairs));
    control.dispatches[vertexPairDispatch + kind] = uvec4((count + 63u) / 64u, 1u, 1u, 0u);
  }
#endif
}

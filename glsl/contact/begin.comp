// Decides whether pairs are found anew in this substep.
#include "contact/kernel.glsl"
layout(local_size_x = 1) in;

void main() {
  bool anew = contactStep.forced == 1 || control.stale == 1u;
  control.stale = 0u;
  control.stopped = 0u;
  control.nearCount = 0u;
  if (anew) {
    control.pairCounts[0] = 0u;
    control.pairCounts[1] = 0u;
    control.searches += 1u;
  }
  uint vertexGroups = anew ? uint(contactStep.vertices + 63) / 64u : 0u;
  uint leafGroups = anew ? uint((1 << contactStep.levels) + 63) / 64u : 0u;
  control.dispatches[vertexDispatch] = uvec4(vertexGroups, 1u, 1u, 0u);
  control.dispatches[leafDispatch] = uvec4(leafGroups, 1u, 1u, 0u);
  for (int level = 0; level < contactStep.levels; ++level) {
    uint groups = anew ? uint((1 << level) + 63) / 64u : 0u;
    control.dispatches[levelDispatch + level] = uvec4(groups, 1u, 1u, 0u);
  }
}

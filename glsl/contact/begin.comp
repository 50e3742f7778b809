// Decides whether this substep searches for pairs again, and sets the sizes of the search dispatches. One invocation in
// total.
#include "contact/kernel.glsl"
layout(local_size_x = 1) in;

uvec4 groupsFor(int items, bool anew) {
  return uvec4(anew ? uint(items + 63) / 64u : 0u, 1u, 1u, 0u);
}

void main() {
  float maxPath = uintBitsToFloat(control.fastest);
  bool anew = contactStep.forced == 1 || control.stale == 1u || maxPath > uintBitsToFloat(control.searched);
  control.maxPath = control.fastest;
  control.fastest = 0u;
  if (anew) control.searched = floatBitsToUint(searchAllowance(maxPath));
  control.stale = 0u;
  control.stopped = 0u;
  control.nearCount = 0u;
  control.candidateCounts[0] = 0u;
  control.candidateCounts[1] = 0u;
  if (anew) {
    control.pairCounts[0] = 0u;
    control.pairCounts[1] = 0u;
  }
  control.dispatches[vertexDispatch] = groupsFor(contactStep.vertices, anew);
  control.dispatches[faceDispatch] = groupsFor(1 << contactStep.faceLevels, anew);
  control.dispatches[edgeDispatch] = groupsFor(1 << contactStep.edgeLevels, anew);
  for (int level = 0; level < max(contactStep.faceLevels, contactStep.edgeLevels); ++level)
    control.dispatches[levelDispatch + level] = groupsFor(1 << level, anew);
}

// What every kernel of contact includes.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "contact/bindings.glsl"
#include "contact/types.glsl"

layout(std140, binding = stepBinding) uniform StepBlock { ContactStep contactStep; };
STATE_ARRAY(pointsBinding, PointBlock, points)
layout(std430, binding = controlBinding) restrict buffer ControlBlock {
  uint pairCounts[2];  // of vertices with faces, of edges with edges
  uint nearCount;
  uint stale;          // 1: something has left its box, so that pairs are to be found anew
  uint stopped;        // 1: planes at rest are to hold everything
  uint mostPairs;      // of either kind, since the start
  uint candidateCounts[2];
  uint fastest;        // m, the longest way of a ball or a vertex of a solid in this substep as a float's bits, while it is summed up,
  uint stir;           // when it is,
  uint searched;       // and for which pairs were found
  uint spare;
  uvec4 dispatches[levelDispatch + maxLevels];
} control;

#include "contact/model.glsl"

vec4 pointAt(int section, int i) {
  return LOAD_ONCE(points, section * contactStep.vertices + i);
}
void keepPoint(int section, int i, vec4 value) {
  STORE_STATE(points, section * contactStep.vertices + i, value);
}
// Where a vertex may be, and half a thickness around.
Hull hullOf(uint vertex) {
  int v = int(vertex);
  precise vec3 low = pointAt(lowSection, v).xyz - pointAt(nextSection, v).w;
  precise vec3 high = pointAt(highSection, v).xyz + pointAt(nextSection, v).w;
  Hull hull;
  hull.low = low;
  hull.high = high;
  return hull;
}
float thicknessOf(ivec4 corners) {
  return thicknessBetween(corners, pointAt(nextSection, corners.x).w, pointAt(nextSection, corners.w).w);
}
int nearestTally(int ball) {
  return upSection * contactStep.vertices + ball;
}
// Whether nothing is carried, so that all begin where they are.
bool nothingCarried() {
  return !hasSolids() || control.stir == 0u;
}
float stirOf() {
  return uintBitsToFloat(control.stir);
}

// Common includes, buffers and helper functions of the contact kernels.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "contact/bindings.glsl"
#include "contact/types.glsl"

layout(std140, binding = stepBinding) uniform StepBlock { ContactStep contactStep; };
STATE_ARRAY(pointsBinding, PointBlock, points)
layout(std430, binding = controlBinding) restrict buffer ControlBlock {
  uint pairCounts[2];  // Number of vertex-face pairs, number of edge-edge pairs
  uint nearCount;
  uint stale;          // 1 if a vertex has left its box, so that pairs must be found again
  uint stopped;        // 1 if all vertices must use the limits for planes that stand still
  uint pairLimit;      // Maximum number of pairs of one kind since the start
  uint candidateCounts[2];
  // Maximum path length of all ball and solid vertices in this substep, in metres as float bits; gather.comp
  // accumulates it
  uint fastest;
  uint maxPath;           // Final value of `fastest` for this substep
  uint searched;       // Value of `maxPath` that the latest pair search allowed for
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
// Returns the box of all positions that a vertex may occupy, enlarged by half the thickness.
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
// Returns true if solids carry no vertex, so that the path of every vertex starts at its position at the substep's
// start.
bool nothingCarried() {
  return !hasSolids() || control.maxPath == 0u;
}
float longestPath() {
  return uintBitsToFloat(control.maxPath);
}

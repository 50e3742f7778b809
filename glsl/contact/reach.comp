// Computes the box of each vertex for the next pair search. The pairs remain complete while the vertices stay in their
// boxes. One invocation per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;

void main() {
  int v = int(gl_GlobalInvocationID.x);
  if (v >= contactStep.vertices) return;
  vec4 next = pointAt(nextSection, v);
  float searchAllowanceOfFrame = isSolid(v) ? 0.0f : uintBitsToFloat(control.searched);
  Hull hull = widened(reachOf(pointAt(nowSection, v).xyz, next.xyz, next.w), searchAllowanceOfFrame);
  // A dead ball gets an inverted box, which overlaps nothing.
  bool nowhere = isBall(v) && pointAt(nowSection, v).w == 0.0f;
  hull.low = nowhere ? vec3(1e30f) : hull.low;
  hull.high = nowhere ? vec3(-1e30f) : hull.high;
  keepPoint(lowSection, v, vec4(hull.low, 0.0f));
  keepPoint(highSection, v, vec4(hull.high, 0.0f));
}

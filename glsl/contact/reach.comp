// Where each vertex may be for as long as the pairs are used that are found next.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;

void main() {
  int v = int(gl_GlobalInvocationID.x);
  if (v >= contactStep.vertices) return;
  vec4 next = pointAt(nextSection, v);
  Hull hull = reachOf(pointAt(nowSection, v).xyz, next.xyz, next.w);
  keepPoint(lowSection, v, vec4(hull.low, 0.0f));
  keepPoint(highSection, v, vec4(hull.high, 0.0f));
}

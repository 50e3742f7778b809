// Reads a simulation's positions back after its colliders moved them. Limits the change so that contact stays valid.
// One invocation per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(partNextBinding, PartNextBlock, partNext)
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int v = first + i;
  vec4 next = pointAt(nextSection, v), settled = LOAD_INPUT(partNext, i);
  vec4 now = pointAt(nowSection, v);
  vec4 high = pointAt(highSection, v);
  precise float maximum = next.w * 1.25f + extraMoveLimit(now.xyz, next.xyz, longestPath(), high.w);
  if (isBall(v) && now.w == 0.0f) {
    keepPoint(wantedSection, v, settled);
    return;
  }
  vec3 wanted = keptWithin(next.xyz, settled.xyz, maximum, pointAt(lowSection, v).xyz, high.xyz);
  keepPoint(wantedSection, v, vec4(wanted, settled.w));
}

// Moves each vertex by the sum of its contact impulses of one round, and clears the sum. One invocation per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = talliesBinding) restrict buffer TallyBlock { ivec4 tallies[]; };

void main() {
  int v = int(gl_GlobalInvocationID.x);
  if (v >= contactStep.movable) return;
  int tally = impulseSection * contactStep.vertices + v;
  ivec4 sum = tallies[tally];
  tallies[tally] = ivec4(0);
  vec4 now = pointAt(nowSection, v);
  float weight = now.w;
  if (sum.w == 0 || weight == 0.0f) return;
  vec4 next = pointAt(nextSection, v), wanted = pointAt(wantedSection, v);
  vec4 high = pointAt(highSection, v);
  precise float maximum = 0.5f * next.w + extraMoveLimit(now.xyz, next.xyz, longestPath(), high.w);
  vec3 pushed = pushedTo(next.xyz, wanted.xyz, weight, sum.xyz, maximum, pointAt(lowSection, v).xyz, high.xyz);
  keepPoint(wantedSection, v, vec4(pushed, wanted.w));
}

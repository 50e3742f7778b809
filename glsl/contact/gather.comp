// Copies a simulation's vertices into the contact arrays and resets their tallies. Marks the pairs as stale if a vertex
// has left its box. One invocation per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(partNowBinding, PartNowBlock, partNow)
INPUT_ARRAY(partNextBinding, PartNextBlock, partNext)
layout(std430, binding = talliesBinding) restrict buffer TallyBlock { ivec4 tallies[]; };
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int v = first + i;
  vec4 now = LOAD_INPUT(partNow, i), next = LOAD_INPUT(partNext, i);
  bool solid = isSolid(v), ball = isBall(v);
  vec4 skin = pointAt(skinSection, v);
  float weight = solid ? 0.0f : ball ? ballWeight(now.w, next.w) : now.w;
  bool gone = ball && weight == 0.0f;
  vec4 high = pointAt(highSection, v);
  bool within = pairsComplete(next.xyz, pointAt(lowSection, v).xyz, high.xyz, longestPath(), high.w);
  if (!within && !gone) control.stale = 1u;
  keepPoint(nowSection, v, vec4(now.xyz, weight));
  keepPoint(nextSection, v, vec4(next.xyz, skin.x));
  keepPoint(wantedSection, v, next);
  tallies[impulseSection * contactStep.vertices + v] = ivec4(0);
  tallies[letSection * contactStep.vertices + v] = ivec4(floatBitsToInt(1.0f));
  if (!hasPath()) return;
  tallies[upSection * contactStep.vertices + v] = ivec4(0, 0, 0, floatBitsToInt(1e30f));
  tallies[downSection * contactStep.vertices + v] = ivec4(0);
  if (gone || !(solid || ball)) return;
  float way = lengthOf(now.xyz, next.xyz);
  if (ball) way = ballMotion(way, skin.z);
  // The bits of non-negative floats compare like the floats.
  if (way > 0.0f) atomicMax(control.fastest, floatBitsToUint(way));
}

// Converts item counts to the arguments of indirect dispatches. From each count, `skipped` is subtracted, and the
// result is limited to `maximum`. A dispatch then needs count * times / each workgroups, arranged in rows of at most
// 32,768. The third dimension has `parts` workgroups, or fewer if there are many items, but at least `minGroupsZ`. One
// invocation writes the arguments of one dispatch.
#include "draw/exact/bindings.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = counterBinding) readonly restrict buffer CounterBlock { uint counters[]; };
// arguments; 4 words per dispatch
layout(std430, binding = dispatchBinding) writeonly restrict buffer DispatchBlock { uint groups[]; };
uniform int counts;
uniform int first;  // index of the first dispatch whose arguments are written
uniform int firstCount;
uniform uint skipped;
uniform uint maximum;
uniform uint times;
uniform uint each;
uniform uint parts;
uniform uint minGroupsZ;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= counts) return;
  uint count = counters[firstCount + i];
  uint taken = min(count - min(count, skipped), maximum) * times;
  uint needed = taken / each + (taken % each != 0u ? 1u : 0u);
  groups[4 * (first + i)] = min(needed, 32768u);
  groups[4 * (first + i) + 1] = (needed + 32767u) / 32768u;
  groups[4 * (first + i) + 2] = clamp(64u / max(needed, 1u), min(minGroupsZ, parts), parts);
}

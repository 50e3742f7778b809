// Whether a user's kernel has done what it must not: its places (four words each, the first one counts) are looked through after
// a frame. What they had when one of them first counted is kept.
#include "common/status.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer ReportBlock { uvec4 reports[]; };
layout(std430, binding = 1) buffer CaughtBlock { uvec4 caught[]; };
uniform int count;    // places of this kernel
uniform int first;    // place of its first one among those of all kernels
uniform uint frame;
uniform bool goesOn;  // the run does not end there

void main() {
  for (int i = 0; i < count; ++i) {
    if (reports[i].x == 0u) continue;
    bool known = goesOn ? status.remark != 0u : status.firstStep != 0xffffffffu;
    if (!known || status.spare1 == frame) {
      caught[first + i] = reports[i];
      status.spare1 = frame;
      if (goesOn)
        status.remark = 1u;
      else
        noteLost(frame, uint(first + i));
    }
  }
}

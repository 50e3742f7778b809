// Collects the error reports of a user's kernel after a frame. One invocation in total. Each report has four words; the
// first word counts its occurrences. In the first frame with a nonzero count, the words are copied to `caught`.
#include "common/status.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer ReportBlock { uvec4 reports[]; };
layout(std430, binding = 1) buffer CaughtBlock { uvec4 caught[]; };
uniform int count;    // number of reports of this kernel
uniform int first;    // index of the kernel's first report in `caught`
uniform uint frame;
uniform bool goesOn;  // true if reports do not end the run

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

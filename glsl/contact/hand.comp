// Shows a simulation where the impulses take its vertices.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(partNextBinding, PartNextBlock, partNext)
uniform int first;
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  STORE_STATE(partNext, i, pointAt(wantedSection, first + i));
}

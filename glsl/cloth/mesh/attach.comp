// Long-range attachments: vertices that are farther from a pin than the cloth between is long.
#include "cloth/mesh/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(attachmentsBinding, AttachmentBlock, attachments)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
#include "cloth/mesh/membrane.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  uvec4 attachment = LOAD_INPUT_WORDS(attachments, k);
  int i = int(attachment.x);
  vec4 here = LOAD_ONCE(nextPositions, i);
  vec3 pin = LOAD_ONCE(nextPositions, int(attachment.y)).xyz;
  STORE_STATE(nextPositions, i, attached(here, pin, intBitsToFloat(int(attachment.z)), intBitsToFloat(int(attachment.w))));
}

// Applies long-range attachments: pulls back vertices whose distance from a pin exceeds the length of the cloth between
// them. One invocation per attachment.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(attachmentsBinding, AttachmentBlock, attachments)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
#if KEEPS
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
#else
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
STATE_ARRAY(trendsBinding, TrendBlock, trends)  // w is 1 if an attachment held the vertex in the previous substep.
#endif
#include "garment/membrane.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  uvec4 attachment = LOAD_INPUT_WORDS(attachments, k);
  int i = int(attachment.x);
#if KEEPS
  vec4 velocity = LOAD_ONCE(velocities, i);
  vec3 shift = attachedShift(LOAD_INPUT(positions, i), LOAD_INPUT(positions, int(attachment.y)).xyz,
                             intBitsToFloat(int(attachment.z)), intBitsToFloat(int(attachment.w)), true);
  precise vec3 sped = velocity.xyz + shift * stepData.perDt;
  STORE_STATE(velocities, i, vec4(sped, velocity.w));
#else
  vec4 here = LOAD_ONCE(nextPositions, i);
  vec3 pin = LOAD_ONCE(nextPositions, int(attachment.y)).xyz;
  vec4 velocity = LOAD_ONCE(velocities, i), trend = LOAD_ONCE(trends, i);
  bool held = trend.w > 0.0f;
  vec4 moved = attached(here, pin, intBitsToFloat(int(attachment.z)), intBitsToFloat(int(attachment.w)), held);
  bool taut = moved.x != here.x || moved.y != here.y || moved.z != here.z;
  STORE_STATE(nextPositions, i, moved);
  STORE_STATE(trends, i, vec4(trend.xyz, taut ? 1.0f : 0.0f));
  STORE_STATE(velocities, i, held ? velocity : pushed(velocity, here, moved));
#endif
}

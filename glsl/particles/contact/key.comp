// Writes a sort record for each slot: the bucket of the particle's cell, and the slot's index. One invocation per slot.
#include "particles/contact/kernel.glsl"
#include "common/status.glsl"
INPUT_ARRAY(placesBinding, PositionBlock, positions)
INPUT_ARRAY(ballStartsBinding, StartBlock, starts)
INPUT_ARRAY(speedsBinding, VelocityBlock, velocities)
STATE_WORDS(recordsBinding, RecordBlock, records)

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= stepData.count) return;
  vec4 here = LOAD_INPUT(positions, i);
  vec4 start = LOAD_INPUT(starts, i);
  bool alive = LOAD_INPUT(velocities, i).w >= 0.0f;
  uint bucket = alive ? ballBucket(ballCell(here.xyz)) : uint(stepData.balls.tableMask);
  STORE_WORDS(records, i, uvec4(bucket, 0u, uint(i), 0u));
  // Balls that move by more than their radius may pass through each other, which causes a remark.
  precise vec3 way = here.xyz - start.xyz;
  float radius = ballRadius(here.w);
  precise float maximum = radius * radius;
  if (alive && ringPlace(i).y < 0 && exactDot(way, way) > maximum) status.remark = 1u;
}

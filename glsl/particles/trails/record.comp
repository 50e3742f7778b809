// Adds the places of a frame to the history of trails, a ring of frames for each trail. One invocation per trail.
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
INPUT_ARRAY(1, VelocityBlock, velocities)
STATE_ARRAY(2, HistoryBlock, history)  // x, y, z: place, m; w: age, negative if the particle does not live
uniform int count;  // trails
uniform int every;  // particles per trail
uniform int room;   // frames in the ring
uniform int slot;   // place of this frame in the ring

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 place = LOAD_INPUT(positions, i * every).xyz;
  STORE_STATE(history, i * room + slot, vec4(place, LOAD_INPUT(velocities, i * every).w));
}

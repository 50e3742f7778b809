// Adds the positions of a frame to the history of the trails, a ring buffer of frames for each trail. One invocation
// per trail.
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
INPUT_ARRAY(1, VelocityBlock, velocities)
STATE_ARRAY(2, HistoryBlock, history)  // xyz: position, m; w: age, negative if the particle is not alive
uniform int count;  // number of trails
uniform int every;  // number of particles per trail
uniform int room;   // number of frames in the ring buffer
uniform int slot;   // index of this frame in the ring buffer

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 place = LOAD_INPUT(positions, i * every).xyz;
  STORE_STATE(history, i * room + slot, vec4(place, LOAD_INPUT(velocities, i * every).w));
}

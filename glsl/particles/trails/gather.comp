// Orders the history of each trail from the current frame backwards. A trail ends where its particle was born. There,
// the frame before shows a particle that is not alive or that is older. One invocation per trail.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
INPUT_ARRAY(1, VelocityBlock, velocities)
INPUT_ARRAY(2, HistoryBlock, history)
STATE_ARRAY(3, PointBlock, points)  // xyz: position, m; w: position in the colours of the particles, 0 to 1
layout(std430, binding = 4) writeonly buffer SpanBlock { ivec4 spans[]; };  // x, y: indices of the first and last
                                                                            // point; z: trail
uniform int count;       // number of trails
uniform int every;       // number of particles per trail
uniform int room;        // number of frames in the ring buffer
uniform int slot;        // index of the current frame in the ring buffer
uniform int recorded;    // number of frames in the ring buffer that are filled
uniform int colorBy;     // a value of sim::Instances::ColorBy
uniform float low;       // value of the first colour
uniform float perRange;  // 1 / (value of the last colour - value of the first colour)

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 velocity = LOAD_INPUT(velocities, i * every);
  float speed = exactSqrt(exactDot(velocity.xyz, velocity.xyz));
  float value = colorBy == 1 ? speed : colorBy == 2 ? LOAD_INPUT(positions, i * every).w : velocity.w;
  precise float place = (value - low) * perRange;
  int last = -1;
  float age = velocity.w;
  for (int back = 0; back < recorded; ++back) {
    vec4 there = LOAD_INPUT(history, i * room + (slot + room - back) % room);
    if (there.w < 0.0 || there.w > age || !isNumber(exactDot(there, there))) break;
    age = there.w;
    STORE_STATE(points, i * room + back, vec4(there.xyz, clamp(place, 0.0, 1.0)));
    last = back;
  }
  // If a trail is not drawn, its only point is at the particle's position, which is within the bounds of the others.
  if (last < 0) STORE_STATE(points, i * room, vec4(LOAD_INPUT(positions, i * every).xyz, 0.0));
  spans[i] = ivec4(0, last, i, 0);
}

// Orders the history of each trail from the present frame backwards. A trail ends where its particle was born: there the
// frame before shows a particle that does not live, or one that is older. One invocation per trail.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
INPUT_ARRAY(1, VelocityBlock, velocities)
INPUT_ARRAY(2, HistoryBlock, history)
STATE_ARRAY(3, PointBlock, points)  // x, y, z: m; w: place in the colours of the particles
layout(std430, binding = 4) writeonly buffer SpanBlock { ivec4 spans[]; };  // x, y: first and last point; z: trail
uniform int count;       // trails
uniform int every;       // particles per trail
uniform int room;        // frames in the ring
uniform int slot;        // place of the present frame in the ring
uniform int recorded;    // frames in the ring that are filled
uniform int colorBy;     // value of sim::Instances::ColorBy
uniform float low;       // value of the first colour
uniform float perRange;  // 1 / (value of the last colour - low)

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
  // The point of a trail that is not drawn lies where the particle is, within the bounds of the others.
  if (last < 0) STORE_STATE(points, i * room, vec4(LOAD_INPUT(positions, i * every).xyz, 0.0));
  spans[i] = ivec4(0, last, i, 0);
}

// Computes the arrows along the velocities of every n-th point. One invocation per arrow.
#include "arrows/arrow.glsl"
INPUT_ARRAY(3, PositionBlock, positions)   // xyz: position, m
INPUT_ARRAY(4, VelocityBlock, velocities)  // xyz: velocity, m/s; w is negative if the point is not alive
uniform int every;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 velocity = LOAD_INPUT(velocities, i * every);
  vec3 place = LOAD_INPUT(positions, i * every).xyz;
  storeArrow(i, place, velocity.xyz, velocity.xyz, velocity.w >= 0.0);
}

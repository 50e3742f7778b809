// Where forces take the vertices, before lengths are kept, and with which velocities.
#include "cloth/mesh/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(trendsBinding, TrendBlock, trends)
INPUT_ARRAY(faceForcesBinding, ForceBlock, faceForces)
INPUT_WORDS(entriesBinding, EntryBlock, entries)
INPUT_WORDS(fansBinding, FanBlock, fans)
INPUT_WORDS(ringsBinding, RingBlock, rings)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)

vec3 loadPoint(int i) {
  return LOAD_INPUT(positions, i).xyz;
}
vec3 loadFaceForce(int i) {
  return LOAD_INPUT(faceForces, i).xyz;
}
uvec4 loadEntry(int i) {
  return LOAD_INPUT_WORDS(entries, i);
}
uvec4 loadRing(int i) {
  return LOAD_INPUT_WORDS(rings, i);
}
#include "cloth/mesh/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 here = LOAD_INPUT(positions, i);
  vec4 velocity = LOAD_ONCE(velocities, i);
  Motion m = predicted(LOAD_INPUT_WORDS(fans, i), here, velocity, LOAD_INPUT(trends, i).xyz, AIR);
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
}

// Predicts the velocities and positions of the vertices from forces, before constraints are applied. One invocation per
// vertex.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_ARRAY(trendsBinding, TrendBlock, trends)
#if KEEPS
INPUT_ARRAY(elementsBinding, ElementBlock, elements)
#else
INPUT_ARRAY(faceForcesBinding, ForceBlock, faceForces)
#endif
INPUT_WORDS(entriesBinding, EntryBlock, entries)
INPUT_WORDS(fansBinding, FanBlock, fans)
INPUT_WORDS(ringsBinding, RingBlock, rings)
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)

vec3 loadPoint(int i) {
  return LOAD_INPUT(positions, i).xyz;
}
vec3 loadFaceForce(int i) {
#if KEEPS
  return vec3(0.0f);
#else
  return LOAD_INPUT(faceForces, i).xyz;
#endif
}
vec4 loadElement(int i) {
#if KEEPS
  return LOAD_INPUT(elements, i);
#else
  return vec4(0.0f);
#endif
}
uvec4 loadEntry(int i) {
  return LOAD_INPUT_WORDS(entries, i);
}
uvec4 loadRing(int i) {
  return LOAD_INPUT_WORDS(rings, i);
}
#include "garment/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 here = LOAD_INPUT(positions, i);
  vec4 velocity = LOAD_ONCE(velocities, i);
  Motion m = predicted(LOAD_INPUT_WORDS(fans, i), here, velocity, LOAD_INPUT(trends, i).xyz, AIR == 1);
  STORE_STATE(velocities, i, vec4(m.velocity, velocity.w));
  STORE_STATE(nextPositions, i, vec4(m.position, here.w));
}

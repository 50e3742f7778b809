// Computes the air force on each corner of a face. One invocation per face. predict.comp sums the forces around each
// vertex.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
INPUT_ARRAY(velocitiesBinding, VelocityBlock, velocities)
INPUT_WORDS(cornersBinding, CornerBlock, corners)
STATE_ARRAY(faceForcesBinding, ForceBlock, faceForces)

vec3 loadPoint(int i) {
  return LOAD_INPUT(positions, i).xyz;
}
vec3 loadVelocity(int i) {
  return LOAD_INPUT(velocities, i).xyz;
}
vec3 loadFaceForce(int i) {
  return vec3(0.0f);
}
uvec4 loadEntry(int i) {
  return uvec4(0u);
}
vec4 loadElement(int i) {
  return vec4(0.0f);
}
uvec4 loadRing(int i) {
  return uvec4(0u);
}
#include "garment/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  uvec4 face = LOAD_INPUT_WORDS(corners, i);
  int a = int(face.x), b = int(face.y), c = int(face.z);
  precise vec3 velocity = (loadVelocity(a) + loadVelocity(b) + loadVelocity(c)) * 0.33333333f;
  STORE_STATE(faceForces, i, vec4(airOnCorner(loadPoint(a), loadPoint(b), loadPoint(c), velocity), 0.0f));
}

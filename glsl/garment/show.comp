// Writes the positions and normals of the drawn mesh. Several drawn vertices may belong to one cloth vertex. One
// invocation per drawn vertex.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
INPUT_WORDS(copiesBinding, CopyBlock, copies)
INPUT_WORDS(fansBinding, FanBlock, fans)
INPUT_WORDS(ringsBinding, RingBlock, rings)
STATE_ARRAY(drawnPositionsBinding, DrawnBlock, drawnPositions)
STATE_ARRAY(drawnNormalsBinding, NormalBlock, drawnNormals)

vec3 loadPoint(int i) {
  return LOAD_INPUT(positions, i).xyz;
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
  return LOAD_INPUT_WORDS(rings, i);
}
#include "garment/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  uint vertex = LOAD_INPUT_WORDS(copies, i).x;
  vec3 here = loadPoint(int(vertex));
  STORE_STATE(drawnPositions, i, vec4(here, 1.0f));
  STORE_STATE(drawnNormals, i, vec4(normalAt(LOAD_INPUT_WORDS(fans, int(vertex)), here), 0.0f));
}

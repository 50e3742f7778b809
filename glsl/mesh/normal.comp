// Normals of the deformed mesh, one vertex an invocation.
#include "mesh/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
INPUT_ARRAY(1, RestBlock, restNormals)
STATE_ARRAY(2, NormalBlock, normals)
INPUT_WORDS(3, FanBlock, fans)
INPUT_WORDS(4, FaceBlock, faces)

vec3 loadDisplaced(int i) {
  return LOAD_INPUT(positions, i).xyz;
}
uvec4 loadFan(int i) {
  return LOAD_INPUT_WORDS(fans, i);
}
uvec4 loadFaces(int i) {
  return LOAD_INPUT_WORDS(faces, i);
}
#include "mesh/normal.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= deformStep.counts.z) return;
  STORE_STATE(normals, i, vec4(gatheredNormal(i, LOAD_INPUT(restNormals, i).xyz), 0));
}

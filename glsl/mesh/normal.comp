// Computes the normals of the deformed mesh. One invocation per vertex.
#include "mesh/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
INPUT_ARRAY(restNormalsBinding, RestBlock, restNormals)
STATE_ARRAY(normalsBinding, NormalBlock, normals)
INPUT_WORDS(fansBinding, FanBlock, fans)
INPUT_WORDS(facesBinding, FaceBlock, faces)

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
  if (i >= deformStep.vertexCount) return;
  STORE_STATE(normals, i, vec4(gatheredNormal(i, LOAD_INPUT(restNormals, i).xyz), 0));
}

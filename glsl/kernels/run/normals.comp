// Computes the vertex normals of a mesh whose vertices are moved by a user's kernels. One invocation per vertex. The
// normal is the normalized sum of the edge cross products of the adjacent faces, so larger faces have a larger weight.
// `ranges` holds for each vertex the start and end of its entries in `faces`. An entry has the other two corners of an
// adjacent face, in winding order.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, PositionBlock, positions)
layout(std430, binding = 1) readonly buffer RangeBlock { ivec2 ranges[]; };  // for each vertex: start and end of its
                                                                             // entries in `faces`
layout(std430, binding = 2) readonly buffer FaceBlock { ivec2 faces[]; };    // the other two corners of a face, in
                                                                             // winding order
STATE_ARRAY(3, NormalBlock, normals)
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 here = LOAD_INPUT(positions, i).xyz;
  precise vec3 sum = vec3(0.0);
  for (int f = ranges[i].x; f < ranges[i].y; ++f) {
    precise vec3 a = LOAD_INPUT(positions, faces[f].x).xyz - here;
    precise vec3 b = LOAD_INPUT(positions, faces[f].y).xyz - here;
    sum += exactCross(a, b);
  }
  float length2 = exactDot(sum, sum);
  precise vec3 unit = sum * exactReciprocal(exactSqrt(length2));
  STORE_STATE(normals, i, vec4(length2 > 0.0 ? unit : vec3(0.0, 1.0, 0.0), 0.0));
}

// Transforms the vertices of a floating body to world space. One invocation per vertex.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "water/float_bindings.glsl"
#include "water/float_types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(floatsBinding, FloatsBlock, bodies)
INPUT_ARRAY(hullPositionsBinding, HullPositionBlock, hullPositions)
INPUT_ARRAY(hullNormalsBinding, HullNormalBlock, hullNormals)
STATE_ARRAY(placedPositionsBinding, PlacedPositionBlock, placedPositions)
STATE_ARRAY(placedNormalsBinding, PlacedNormalBlock, placedNormals)
uniform int count;
uniform int body;
uniform vec3 origin;  // Position of the water's origin in world space

vec3 turned(vec4 q, vec3 v) {
  precise vec3 inner = exactCross(q.xyz, v) + q.w * v;
  precise vec3 result = v + 2.0f * exactCross(q.xyz, inner);
  return result;
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 at = LOAD_INPUT(bodies, body * floatTexels).xyz;
  vec4 turn = LOAD_INPUT(bodies, body * floatTexels + 1);
  precise vec3 place = origin + (at + turned(turn, LOAD_INPUT(hullPositions, i).xyz));
  STORE_STATE(placedPositions, i, vec4(place, 1.0f));
  STORE_STATE(placedNormals, i, vec4(turned(turn, LOAD_INPUT(hullNormals, i).xyz), 0.0f));
}

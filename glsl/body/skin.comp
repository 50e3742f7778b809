// Computes the skinned vertices at a time within the frame. One invocation per vertex. If NORMALS is defined, also
// computes the normals.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "body/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(restPositionsBinding, RestBlock, restPositions)
INPUT_WORDS(followBinding, FollowBlock, follow)
INPUT_ARRAY(weightsBinding, WeightBlock, weights)
INPUT_ARRAY(posesBinding, PoseBlock, poses)
STATE_ARRAY(positionsBinding, PositionBlock, positions)
#ifdef NORMALS
INPUT_ARRAY(restNormalsBinding, RestNormalBlock, restNormals)
STATE_ARRAY(normalsBinding, NormalBlock, normals)
#endif
uniform int count;
uniform int joints;
uniform float before;  // Weight of the pose at the start of the frame
uniform float now;

vec4 loadPose(int i) {
  return LOAD_INPUT(poses, i);
}
#include "body/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  Moment moment;
  moment.joints = joints;
  moment.before = before;
  moment.now = now;
  Blend blend = blendOf(LOAD_INPUT_WORDS(follow, i), LOAD_INPUT(weights, i), moment);
  STORE_STATE(positions, i, vec4(skinnedPosition(blend, LOAD_INPUT(restPositions, i).xyz), 1.0f));
#ifdef NORMALS
  STORE_STATE(normals, i, vec4(skinnedNormal(blend, LOAD_INPUT(restNormals, i).xyz), 0.0f));
#endif
}

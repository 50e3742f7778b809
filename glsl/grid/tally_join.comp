// Combines the partial sums of a tally. Each of the `lanes` results combines the tallyJoined inputs lane, lane + lanes,
// and so on. The last round has one lane and multiplies by the factors. One invocation per lane.
#include "common/memory.glsl"
#include "grid/tally_types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(sumsInBinding, InBlock, lanesBefore)
STATE_ARRAY(sumsOutBinding, OutBlock, joined)
uniform int lanes;
uniform vec4 sumFactor, maxFactor;

void main() {
  int lane = int(gl_GlobalInvocationID.x);
  if (lane >= lanes) return;
  precise vec4 sums = vec4(0.0f);
  vec4 maximum = vec4(-1e30f);
  for (int i = 0; i < tallyJoined; ++i) {
    int before = 2 * (lane + i * lanes);
    sums = sums + LOAD_INPUT(lanesBefore, before);
    maximum = max(maximum, LOAD_INPUT(lanesBefore, before + 1));
  }
  sums = sums * sumFactor;
  precise vec4 greatest = maximum * maxFactor;
  STORE_STATE(joined, 2 * lane, sums);
  STORE_STATE(joined, 2 * lane + 1, greatest);
}

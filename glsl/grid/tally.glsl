// Sums quantities over all cells of a field in a fixed order: lane i sums the cells i, i + tallyLanes, and so on. The
// including file provides cellCount() and tallied(int cell). The members `sums` are added, and the members `maximum` are
// combined by max.
#include "grid/tally_types.glsl"
STATE_ARRAY(sumsOutBinding, SumBlock, laneSums)

void tallyLane(int lane, int cellCount) {
  precise vec4 sums = vec4(0.0f);
  vec4 maximum = vec4(-1e30f);
  for (int cell = lane; cell < cellCount; cell += tallyLanes) {
    Tallied one = tallied(cell);
    sums = sums + one.sums;
    maximum = max(maximum, one.maximum);
  }
  STORE_STATE(laneSums, 2 * lane, sums);
  STORE_STATE(laneSums, 2 * lane + 1, maximum);
}

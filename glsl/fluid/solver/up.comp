// Variant of ascend.comp that processes LEVELS middle levels in one dispatch, similar to down.comp. Stores only the
// corrections of the finest level.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
const int tile = 32;
const int maximum = tile + 4;
layout(local_size_x = maximum / 2, local_size_y = maximum / 2) in;  // One block per invocation
layout(std430, binding = poolBinding) readonly restrict buffer PoolBlock { vec4 pool[]; };
layout(std430, binding = raisedBinding) readonly buffer RaisedBlock { vec4 raisedPool[]; };
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { vec4 raisedOut[]; };
INPUT_WORDS(weightsBinding, WeightBlock, weights)
// For each level, finest first, followed by the next coarser level: xy size in cells; z element index of the openings
uniform ivec4 levels[5];
uniform int rhsStart, wayStart;  // Element indices as in down.comp; the corrections on the way to finer levels start at
                                 // 0

const int windowStride = maximum + 2;
shared float values[windowStride * windowStride];
shared float coarseValues[(tile / 2 + 8) * (tile / 2 + 8)];  // Values of the coarser level, in its window
#include "fluid/solver/block.glsl"
#include "fluid/solver/window.glsl"

// Returns the width of a level's margin in cells: two cells for the sweep, plus the coarse cells around the finer
// level's blocks.
int marginOf(int number) {
  return number == 0 ? 2 : number == 1 ? 4 : 6;
}

// Returns the correction of a cell of the level after `number`.
float coarseAt(int number, ivec2 c, ivec2 group) {
  ivec4 grid = levels[number + 1];
  bool last = number == LEVELS - 1;
  ivec2 near = clamp(c, ivec2(0), grid.xy - 1);
#if LEFT == 4
  near.x = c.x = last ? (c.x + 16 * grid.x) % grid.x : c.x;
#endif
#if TOP == 4
  near.y = c.y = last ? (c.y + 16 * grid.y) % grid.y : c.y;
#endif
  if (walledOff(c, grid.xy)) return noCell;
  float value;
  if (last) {
    value = raisedPool[grid.z + (near.y >> 1) * (grid.x / 2 + 1) + (near.x >> 1)][2 * (near.y & 1) + (near.x & 1)];
  } else {
    int margin = marginOf(number + 1), own = tile >> (number + 1);
    ivec2 inWindow = near - (group * own - margin);
    value = coarseValues[inWindow.y * (own + 2 * margin) + inWindow.x];
  }
  return value < noCell && near != c ? -value : value;
}

vec3 coarseRow(int number, ivec2 c, ivec2 group) {
  return vec3(coarseAt(number, c - ivec2(1, 0), group), coarseAt(number, c, group), coarseAt(number, c + ivec2(1, 0), group));
}

void ascend(int number, ivec2 group, ivec2 lane) {
  ivec4 grid = levels[number];
  int margin = marginOf(number), across = (tile >> number) / 2 + margin;  // Width of the window in blocks
  ivec2 block = (group * (tile >> number) - margin) / 2 + lane, place = blockWithin(block, grid.xy);
  bool used = lane.x < across && lane.y < across;
  int at = cornerOf(lane), element = place.y * (grid.x / 2 + 1) + place.x;
  Block b;
  vec4 here = vec4(0.0);
  if (used) {
    b = blockAt(place, grid.xy, grid.z);
    if (b.inside != 0) {
      b.rhs = pool[rhsStart + grid.z + element];
      here = raisedPool[wayStart + grid.z + element];
      raiseBlock(b, here, coarseRow(number, block - ivec2(0, 1), group), coarseRow(number, block, group),
                 coarseRow(number, block + ivec2(0, 1), group));
    }
    putReds(at, here);
    putBlacks(at, here);
  }
  barrier();
  if (used) {
    sweepReds(b, here, besideReds(at));
    putReds(at, here);
  }
  barrier();
  if (used) {
    sweepBlacks(b, here, besideBlacks(at));
    int inner = margin / 2;
    if (number > 0) {
      int i = 4 * lane.y * across + 2 * lane.x;
      coarseValues[i] = here.x;
      coarseValues[i + 1] = here.y;
      coarseValues[i + 2 * across] = here.z;
      coarseValues[i + 2 * across + 1] = here.w;
    } else if (lane.x >= inner && lane.y >= inner && lane.x < across - inner && lane.y < across - inner && place == block &&
               b.inside != 0) {
      raisedOut[grid.z + element] = here;
    }
  }
  barrier();
}

void main() {
  for (int i = LEVELS - 1; i >= 0; --i) ascend(i, ivec2(gl_WorkGroupID.xy), ivec2(gl_LocalInvocationID.xy));
}

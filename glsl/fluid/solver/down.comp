// Variant of descend.comp that processes LEVELS middle levels in one dispatch. A workgroup takes `tile` x `tile` cells
// of the finest level and all coarser cells below them, and also computes the neighbours' cells that it needs instead
// of waiting for other workgroups. Used only on the storage path. On a torus, all these levels must have an even number
// of cells per axis.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
const int tile = 32;
// Returns the width of a level's margin in cells: twice the margin of the coarser level, plus two cells for the sweep.
int marginOf(int number) {
  return (2 << (LEVELS - number)) - 2;
}
const int maximum = tile + 2 * ((2 << LEVELS) - 2);
layout(local_size_x = maximum / 2, local_size_y = maximum / 2) in;  // One block per invocation
layout(std430, binding = poolBinding) readonly buffer PoolBlock { vec4 pool[]; };
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { float poolOut[]; };
layout(std430, binding = raisedOutBinding) writeonly restrict buffer RaisedOutBlock { vec4 raisedOut[]; };
INPUT_WORDS(weightsBinding, WeightBlock, weights)
// One entry for each of the LEVELS levels, finest first, and one for the next coarser level, which gets the residual:
// xy size in cells; z element index of the openings
uniform ivec4 levels[4];
// Element indices of the right-hand sides in `pool` and of the corrections on the way to coarser levels. Each level's
// offset from them equals the offset of its openings.
uniform int rhsStart, wayStart;

const int windowStride = maximum + 2;
shared float values[windowStride * windowStride];
shared float missing[(maximum / 2 - 2) * (maximum / 2 - 2)];  // Right-hand sides of the coarser level, in its window
#include "fluid/solver/block.glsl"
#include "fluid/solver/window.glsl"

void descend(int number, ivec2 group, ivec2 lane) {
  ivec4 grid = levels[number];
  int margin = marginOf(number), across = (tile >> number) / 2 + margin;  // Width of the window in blocks
  ivec2 block = (group * (tile >> number) - margin) / 2 + lane, place = blockWithin(block, grid.xy);
  bool used = lane.x < across && lane.y < across;
  int at = cornerOf(lane), element = place.y * (grid.x / 2 + 1) + place.x;
  Block b;
  vec4 here = vec4(0.0);
  if (used) {
    b = blockAt(place, grid.xy, grid.z);
    if (number > 0) {
      int i = 4 * lane.y * across + 2 * lane.x;
      b.rhs = vec4(missing[i], missing[i + 1], missing[i + 2 * across], missing[i + 2 * across + 1]);
    } else if (b.inside != 0) {
      b.rhs = pool[rhsStart + grid.z + element];
    }
    sweepFirstReds(b, here);
    putReds(at, here);
  }
  barrier();
  if (used) {
    sweepBlacks(b, here, besideBlacks(at));
    putBlacks(at, here);
  }
  barrier();
  if (used && lane.x > 0 && lane.y > 0 && lane.x < across - 1 && lane.y < across - 1) {
    float left = leftInReds(b, here, besideReds(at));
    missing[(lane.y - 1) * (across - 2) + lane.x - 1] = left;
    int inner = margin / 2;
    bool own = lane.x >= inner && lane.y >= inner && lane.x < across - inner && lane.y < across - inner;
    if (own && place == block && b.inside != 0) {
      raisedOut[wayStart + grid.z + element] = here;
      int coarser = rhsStart + levels[number + 1].z + (block.y >> 1) * (levels[number + 1].x / 2 + 1) + (block.x >> 1);
      poolOut[4 * coarser + 2 * (block.y & 1) + (block.x & 1)] = left;
    }
  }
  barrier();
}

void main() {
  for (int i = 0; i < LEVELS; ++i) descend(i, ivec2(gl_WorkGroupID.xy), ivec2(gl_LocalInvocationID.xy));
}

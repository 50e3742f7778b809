// descend.comp for LEVELS middle levels in a dispatch: a work group takes `tile` x `tile` cells of the finest and all below them, and
// repeats of its neighbours' what it needs, so that nobody waits for anybody. Of storage blocks; on a torus all these levels are
// an even number of cells around.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
const int tile = 32;
// How many cells beside its own a level's window has: twice those of the coarser one, and two for the sweep.
int marginOf(int number) {
  return (2 << (LEVELS - number)) - 2;
}
const int most = tile + 2 * ((2 << LEVELS) - 2);
layout(local_size_x = most / 2, local_size_y = most / 2) in;  // a block each
layout(std430, binding = poolBinding) readonly buffer PoolBlock { vec4 pool[]; };
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { float poolOut[]; };
layout(std430, binding = raisedOutBinding) writeonly restrict buffer RaisedOutBlock { vec4 raisedOut[]; };
INPUT_WORDS(weightsBinding, WeightBlock, weights)
uniform ivec4 levels[4];  // the finest first, and the one below them all: cells; elements: where its openings start
uniform int rhsStart, wayStart;  // elements: what is missing, in `pool`, and corrections on the way down, from there as openings

const int windowStride = most + 2;
shared float values[windowStride * windowStride];
shared float missing[(most / 2 - 2) * (most / 2 - 2)];  // of the coarser level, in its window
#include "fluid/solver/block.glsl"
#include "fluid/solver/window.glsl"

void descend(int number, ivec2 group, ivec2 lane) {
  ivec4 grid = levels[number];
  int margin = marginOf(number), across = (tile >> number) / 2 + margin;  // blocks
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

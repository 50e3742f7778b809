// Multigrid step to a coarser level. Starting from zero, applies a red-black sweep whose red half is overrelaxed. The
// residuals of the red cells become the right-hand side of the coarser level; black cells have a residual of 0. An
// invocation processes a block of 2x2 cells and also computes the neighbouring cells that it needs. If TILE_A_GROUP is
// defined, a workgroup processes one tile that is not open and its invocations exchange cells through shared memory,
// because the code for such tiles is long but they are few.
#include "fluid/solver/levels.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { float poolOut[]; };
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { vec4 raisedOut[]; };

void store(ivec2 block, int element, vec4 values, float left) {
  raisedOut[level.way + element] = values;
  ivec2 coarse = (level.cells + 1) / 2;
  if (block.x >= coarse.x || block.y >= coarse.y) return;
  poolOut[4 * (level.coarseRhs + (block.y >> 1) * (coarse.x / 2 + 1) + (block.x >> 1)) + 2 * (block.y & 1) + (block.x & 1)] = left;
}

#if IN_THE_OPEN != 0
void sweepOpen(ivec2 block, int element, int row) {
  vec4 here = LOAD_INPUT(pool, level.rhs + element);
  vec4 before = LOAD_INPUT(pool, level.rhs + element - 1), after = LOAD_INPUT(pool, level.rhs + element + 1);
  vec4 above = LOAD_INPUT(pool, level.rhs + element - row), below = LOAD_INPUT(pool, level.rhs + element + row);
  vec4 aboveBefore = LOAD_INPUT(pool, level.rhs + element - row - 1), belowAfter = LOAD_INPUT(pool, level.rhs + element + row + 1);
  float r00 = begunOpen(here.x), r11 = begunOpen(here.w);
  float rn0 = begunOpen(before.x), rm1 = begunOpen(before.w);
  float r20 = begunOpen(after.x), r31 = begunOpen(after.w);
  float r0n = begunOpen(above.x), r1m = begunOpen(above.w);
  float r02 = begunOpen(below.x), r13 = begunOpen(below.w);
  float rmm = begunOpen(aboveBefore.w), r22 = begunOpen(belowAfter.x);
  float b10 = relaxedOpen(here.y, aroundOpen(r00, r20, r1m, r11)), b01 = relaxedOpen(here.z, aroundOpen(rm1, r11, r00, r02));
  float bm0 = relaxedOpen(before.y, aroundOpen(rn0, r00, rmm, rm1)), b0m = relaxedOpen(above.z, aroundOpen(rmm, r1m, r0n, r00));
  float b21 = relaxedOpen(after.z, aroundOpen(r11, r31, r20, r22)), b12 = relaxedOpen(below.y, aroundOpen(r02, r22, r11, r13));
  store(block, element, vec4(r00, b10, b01, r11),
        restricted(residualOpen(here.x, r00, bm0, b10, b0m, b01), residualOpen(here.w, r11, b01, b21, b10, b12)));
}
#endif

#ifdef TILE_A_GROUP
#include "fluid/solver/block.glsl"
const int windowStride = 14;
shared float values[14 * 14];
#include "fluid/solver/window.glsl"

void sweepTile(ivec2 tile) {
  ivec2 lane = ivec2(gl_LocalInvocationID.xy);
  ivec2 block = 4 * tile + lane - 1;
  bool used = lane.x < 6 && lane.y < 6;
  ivec2 place = blockWithin(block, level.cells);
  int at = used ? cornerOf(lane) : cornerOf(ivec2(0));
  Block b;
  vec4 here = vec4(0.0);
  if (used) {
    b = blockAt(place, level.cells, level.weights);
    if (b.inside != 0) b.rhs = LOAD_INPUT(pool, level.rhs + place.y * blocksOf(level.cells).x + place.x);
    sweepFirstReds(b, here);
    putReds(at, here);
  }
  barrier();
  if (used) {
    sweepBlacks(b, here, besideBlacks(at));
    putBlacks(at, here);
  }
  barrier();
  bool own = lane.x > 0 && lane.y > 0 && lane.x < 5 && lane.y < 5;
  if (!own || place != block || b.inside == 0) return;
  store(block, block.y * blocksOf(level.cells).x + block.x, here, leftInReds(b, here, besideReds(at)));
}
#elif IN_THE_OPEN != 1
float redAt(ivec2 place) {
  ivec2 c = within(place);
  if (!isInside(c) || !isRed(c)) return 0.0;
  return begun(inPool(level.rhs, c), diagonal(weightsOf(c)));
}

// Returns the value of a black cell after the sweep. On a torus with an odd number of cells, the cell at the seam can
// be red.
float blackAt(ivec2 place, float left, float right, float top, float bottom) {
  ivec2 c = within(place);
  if (!isInside(c)) return 0.0;
  vec4 w = weightsOf(c);
  float rhs = inPool(level.rhs, c), diag = diagonal(w);
  return isRed(c) ? begun(rhs, diag) : relaxed(rhs, neighbours(w, left, right, top, bottom), diag);
}

float leftOver(ivec2 c, float value, float left, float right, float top, float bottom) {
  if (!isInside(c)) return 0.0;
  return residual(inPool(level.rhs, c), weightsOf(c), value, left, right, top, bottom);
}

void sweepOther(ivec2 block, int element, int row) {
  ivec2 o = 2 * block;
  // The two letters or digits in a name such as r00 give the offset from the block's first cell, where m stands for -1
  // and n for -2.
  float r00 = redAt(o), r11 = redAt(o + ivec2(1, 1));
  float rn0 = redAt(o + ivec2(-2, 0)), r20 = redAt(o + ivec2(2, 0)), r31 = redAt(o + ivec2(3, 1));
  float r0n = redAt(o + ivec2(0, -2)), r02 = redAt(o + ivec2(0, 2)), r13 = redAt(o + ivec2(1, 3));
  float rmm = redAt(o + ivec2(-1, -1)), rm1 = redAt(o + ivec2(-1, 1));
  float r1m = redAt(o + ivec2(1, -1)), r22 = redAt(o + ivec2(2, 2));
  float b10 = blackAt(o + ivec2(1, 0), r00, r20, r1m, r11);
  float b01 = blackAt(o + ivec2(0, 1), rm1, r11, r00, r02);
  float bm0 = blackAt(o + ivec2(-1, 0), rn0, r00, rmm, rm1);
  float b0m = blackAt(o + ivec2(0, -1), rmm, r1m, r0n, r00);
  float b21 = blackAt(o + ivec2(2, 1), r11, r31, r20, r22);
  float b12 = blackAt(o + ivec2(1, 2), r02, r22, r11, r13);
  store(block, element, vec4(r00, b10, b01, r11),
        restricted(leftOver(o, r00, bm0, b10, b0m, b01), leftOver(o + ivec2(1, 1), r11, b01, b21, b10, b12)));
}
#endif

void main() {
#ifdef TILE_A_GROUP
  if (!inTheOpen()) {
    ivec2 tile = tileHere();
    if (tile.x < 0xffff) sweepTile(tile);
    return;
  }
#endif
  ivec2 block = blockHere();
  ivec2 blocks = blocksOf(level.cells);
  if (block.x >= blocks.x || block.y >= blocks.y) return;
  int element = block.y * blocks.x + block.x;
#if IN_THE_OPEN != 0
  if (inTheOpen()) sweepOpen(block, element, blocks.x);
#endif
#if IN_THE_OPEN != 1 && !defined TILE_A_GROUP
  if (!inTheOpen()) sweepOther(block, element, blocks.x);
#endif
}

// Solves the coarsest levels, which have at most 64x64 cells, in a single workgroup: from fine to coarse, overrelaxed
// sweeps (SOR) on the coarsest level, and back from coarse to fine. The results equal the ones of descend.comp,
// bottom.comp and ascend.comp. Corrections stay in shared memory and are updated in place. Therefore, no level may be
// periodic with an odd number of cells, because two cells of the same colour would then be neighbours at the seam.
#ifdef SUBGROUPS
#extension GL_KHR_shader_subgroup_basic : require
#endif
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
const int lanes = 1024;
layout(local_size_x = lanes) in;
layout(std430, binding = poolBinding) readonly restrict buffer PoolBlock { vec4 pool[]; };
layout(std430, binding = raisedOutBinding) writeonly restrict buffer RaisedOutBlock { vec4 raisedOut[]; };
INPUT_WORDS(weightsBinding, WeightBlock, weights)
// For each level, finest first: xy size in cells; z element index of the openings; w index of the first cell in
// `values`
uniform ivec4 levels[4];
uniform int levelCount;
uniform int rhsStart, upStart;  // Indices of the finest level's first elements in `pool` and `raisedOut`

shared float values[5440];  // Values of all levels: 64x64 cells on the finest level, and a quarter as many on each
                            // further level
shared float missing[1344];  // Right-hand sides of all levels except the finest
shared float others[bottomCells + 1];  // Values of the coarsest level, followed by a 0 for cells outside the grid
#include "fluid/solver/block.glsl"

ivec2 within(ivec2 c, ivec2 cells) {
#if LEFT == 4
  c.x = c.x < 0 ? c.x + cells.x : c.x >= cells.x ? c.x - cells.x : c.x;
#endif
#if TOP == 4
  c.y = c.y < 0 ? c.y + cells.y : c.y >= cells.y ? c.y - cells.y : c.y;
#endif
  return c;
}

bool isInside(ivec2 c, ivec2 cells) {
  return c.x >= 0 && c.y >= 0 && c.x < cells.x && c.y < cells.y;
}

float valueAt(ivec4 grid, ivec2 place) {
  ivec2 c = within(place, grid.xy);
  return isInside(c, grid.xy) ? values[grid.w + c.y * grid.x + c.x] : 0.0;
}

float missingAt(ivec4 grid, ivec2 c) {
  return isInside(c, grid.xy) ? missing[grid.w - levels[0].x * levels[0].y + c.y * grid.x + c.x] : 0.0;
}

// Returns the block of this invocation on a level. The finest level has up to 32 blocks per row, each coarser level
// half as many.
ivec2 blockHere(int number) {
  int i = int(gl_LocalInvocationIndex), bits = 5 - number;
  return ivec2(i & ((1 << bits) - 1), i >> bits);
}

void put(ivec4 grid, ivec2 block, int inside, vec4 here) {
  int at = grid.w + 2 * block.y * grid.x + 2 * block.x;
  if ((inside & 1) != 0) values[at] = here.x;
  if ((inside & 2) != 0) values[at + 1] = here.y;
  if ((inside & 4) != 0) values[at + grid.x] = here.z;
  if ((inside & 8) != 0) values[at + grid.x + 1] = here.w;
}

// Returns the neighbours outside the block for sweepReds() and leftInReds().
vec4 besideReds(ivec4 grid, ivec2 c) {
  return vec4(valueAt(grid, c - ivec2(1, 0)), valueAt(grid, c - ivec2(0, 1)), valueAt(grid, c + ivec2(2, 1)),
              valueAt(grid, c + ivec2(1, 2)));
}

// Returns the neighbours outside the block for sweepBlacks().
vec4 besideBlacks(ivec4 grid, ivec2 c) {
  return vec4(valueAt(grid, c + ivec2(2, 0)), valueAt(grid, c + ivec2(1, -1)), valueAt(grid, c + ivec2(-1, 1)),
              valueAt(grid, c + ivec2(0, 2)));
}

void descend(int number, inout Block b, inout vec4 here) {
  ivec4 grid = levels[number], coarse = levels[number + 1];
  ivec2 block = blockHere(number), c = 2 * block;
  if (number > 0)
    b.rhs = vec4(missingAt(grid, c), missingAt(grid, c + ivec2(1, 0)), missingAt(grid, c + ivec2(0, 1)), missingAt(grid, c + ivec2(1, 1)));
  here = vec4(0.0);
  sweepFirstReds(b, here);
  put(grid, block, b.inside, here);
  barrier();
  if (b.inside != 0) {
    sweepBlacks(b, here, besideBlacks(grid, c));
    put(grid, block, b.inside & 6, here);
  }
  barrier();
  if (b.inside != 0)
    missing[coarse.w - levels[0].x * levels[0].y + block.y * coarse.x + block.x] = leftInReds(b, here, besideReds(grid, c));
  barrier();
}

vec2 facesOf(ivec4 grid, ivec2 c) {
  uvec4 four = LOAD_INPUT_WORDS(weights, grid.z + (c.y >> 1) * (grid.x / 2 + 1) + (c.x >> 1));
  return faceWeights((c.y & 1) == 0 ? ((c.x & 1) == 0 ? four.x : four.y) : ((c.x & 1) == 0 ? four.z : four.w));
}

// Returns a coarse cell's correction, like coarseAt() of ascend.comp.
float coarseAt(ivec4 coarse, ivec2 place) {
  ivec2 c = within(place, coarse.xy);
  if (walledOff(c, coarse.xy)) return noCell;
  ivec2 near = clamp(c, ivec2(0), coarse.xy - 1);
  float value = values[coarse.w + near.y * coarse.x + near.x];
  return value < noCell && near != c ? -value : value;
}

vec3 coarseRow(ivec4 coarse, ivec2 c) {
  return vec3(coarseAt(coarse, c - ivec2(1, 0)), coarseAt(coarse, c), coarseAt(coarse, c + ivec2(1, 0)));
}

void ascend(int number, Block b, inout vec4 here) {
  ivec4 grid = levels[number], coarse = levels[number + 1];
  ivec2 block = blockHere(number), c = 2 * block;
  if (b.inside != 0) {
    raiseBlock(b, here, coarseRow(coarse, block - ivec2(0, 1)), coarseRow(coarse, block), coarseRow(coarse, block + ivec2(0, 1)));
    put(grid, block, b.inside, here);
  }
  barrier();
  if (b.inside != 0) {
    sweepReds(b, here, besideReds(grid, c));
    put(grid, block, b.inside & 9, here);
  }
  barrier();
  if (b.inside != 0) {
    sweepBlacks(b, here, besideBlacks(grid, c));
    put(grid, block, b.inside & 6, here);
  }
  barrier();
}

// A cell of the coarsest level, with the indices of its neighbours in `others`. A missing neighbour has the last index,
// which holds 0.
struct Bottom {
  int parity;  // Colour of the cell (0 or 1), or -1 if there is no cell
  ivec4 beside;
  vec4 weights;
  float each, diag, rhs, here;
};

int placeBeside(ivec4 grid, ivec2 place) {
  ivec2 c = within(place, grid.xy);
  return isInside(c, grid.xy) ? c.y * grid.x + c.x : bottomCells;
}

Bottom bottomAt(ivec4 grid, int i) {
  ivec2 c = ivec2(i % grid.x, i / grid.x);
  Bottom b = Bottom(-1, ivec4(bottomCells), vec4(0.0), 0.0, 0.0, 0.0, 0.0);
  if (i >= bottomCells || c.y >= grid.y) return b;
  b.parity = (c.x + c.y) & 1;
  b.beside = ivec4(placeBeside(grid, c - ivec2(1, 0)), placeBeside(grid, c + ivec2(1, 0)), placeBeside(grid, c - ivec2(0, 1)),
                   placeBeside(grid, c + ivec2(0, 1)));
  vec2 own = facesOf(grid, c);
  b.weights = vec4(own.x, facesOf(grid, c + ivec2(1, 0)).x, own.y, facesOf(grid, c + ivec2(0, 1)).y);
  b.diag = diagonal(b.weights);
  b.each = relaxing(b.diag);
  return b;
}

void sweepBottom(inout Bottom b, int i, int color) {
  if (b.parity != color) return;
  float sum = neighbours(b.weights, others[b.beside.x], others[b.beside.y], others[b.beside.z], others[b.beside.w]);
  b.here = overrelaxed(b.here, relaxedBy(b.each, b.rhs, sum, b.diag));
  others[i] = b.here;
}

// Returns the right-hand side of a cell of the coarsest level. If this is the only level (`alone` is true), the
// right-hand side is in `values`.
float missingAtBottom(ivec4 grid, int i, bool alone) {
  ivec2 c = ivec2(i % grid.x, i / grid.x);
  return alone ? valueAt(grid, c) : missingAt(grid, c);
}

// Solves the coarsest level with one cell per invocation. If SUBGROUPS is defined, one subgroup of 32 invocations
// processes two cells per invocation, so that no workgroup barriers are needed.
void solveCoarsest(ivec4 grid, Bottom a, Bottom b, bool alone) {
  int lane = int(gl_LocalInvocationIndex);
  a.rhs = missingAtBottom(grid, lane, alone);
  if (lane <= bottomCells) others[lane] = 0.0;
#ifdef SUBGROUPS
  b.rhs = missingAtBottom(grid, lane + 32, alone);
  barrier();
  if (lane < 32)
    for (int i = 0; i < bottomSweeps; ++i)
      for (int color = 0; color < 2; ++color) {
        sweepBottom(a, lane, color);
        sweepBottom(b, lane + 32, color);
        subgroupMemoryBarrierShared();
        subgroupBarrier();
      }
#else
  barrier();
  for (int i = 0; i < 2 * bottomSweeps; ++i) {
    sweepBottom(a, lane, i & 1);
    barrier();
  }
#endif
  barrier();
  if (lane < grid.x * grid.y) values[grid.w + lane] = others[lane];
  barrier();
}

Block loaded(int number, int last) {
  ivec4 grid = levels[number];
  Block none = Block(uvec4(0u), uvec2(0u), uvec2(0u), vec4(0.0), 0);
  if (number >= last) return none;
  return blockAt(blockHere(number), grid.xy, grid.z);
}

void main() {
  int last = levelCount - 1, lane = int(gl_LocalInvocationIndex);
  // All loads from memory are issued together.
  Block first = loaded(0, last), second = loaded(1, last), third = loaded(2, last);
  Bottom cell = bottomAt(levels[last], lane), other = cell;
#ifdef SUBGROUPS
  if (lane >= 32) cell.parity = -1;
  other = bottomAt(levels[last], lane < 32 ? lane + 32 : bottomCells);
#endif
  ivec2 block = blockHere(0), c = 2 * block;
  int element = block.y * (levels[0].x / 2 + 1) + block.x, inside = cellsInside(block, levels[0].xy);
  vec4 rhs = vec4(0.0), ofFirst = vec4(0.0), ofSecond = vec4(0.0), ofThird = vec4(0.0);
  if (inside != 0) rhs = pool[rhsStart + element];
  first.rhs = rhs;
  if (last > 0)
    descend(0, first, ofFirst);
  else
    put(levels[0], block, inside, rhs);
  if (last > 1) descend(1, second, ofSecond);
  if (last > 2) descend(2, third, ofThird);
  barrier();
  solveCoarsest(levels[last], cell, other, last == 0);
  if (last > 2) ascend(2, third, ofThird);
  if (last > 1) ascend(1, second, ofSecond);
  if (last > 0) ascend(0, first, ofFirst);
  if (inside != 0)
    raisedOut[upStart + element] = vec4(valueAt(levels[0], c), valueAt(levels[0], c + ivec2(1, 0)), valueAt(levels[0], c + ivec2(0, 1)),
                                        valueAt(levels[0], c + ivec2(1, 1)));
}

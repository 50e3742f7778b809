// One level of the pressure solver's multigrid. Values in `pool` and face openings in `weights` are stored in blocks of
// 2x2 cells per element. The blocks extend at least one cell beyond the last cell. For levels and weights, see
// src/sim/fluid/levels.hpp.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
// Declared without `restrict`, because the same kernel writes other parts of the same buffer.
#ifdef TEXEL_PATH
#define POOL_ARRAY(unit, block, name) layout(binding = unit) uniform samplerBuffer name;
#else
#define POOL_ARRAY(unit, block, name) layout(std430, binding = unit) readonly buffer block { vec4 name[]; };
#endif
POOL_ARRAY(poolBinding, PoolBlock, pool)
POOL_ARRAY(raisedBinding, RaisedBlock, raisedPool)
INPUT_WORDS(weightsBinding, WeightBlock, weights)
layout(std140, binding = levelBinding) uniform LevelBlock { FluidLevelPlace level; };

ivec2 blocksOf(ivec2 count) {
  return count / 2 + 1;
}

ivec2 within(ivec2 c) {
#if LEFT == 4
  c.x = c.x < 0 ? c.x + level.cells.x : c.x >= level.cells.x ? c.x - level.cells.x : c.x;
  // Levels with one or two cells per axis can need two wraps.
  c.x = c.x < 0 ? c.x + level.cells.x : c.x >= level.cells.x ? c.x - level.cells.x : c.x;
#endif
#if TOP == 4
  c.y = c.y < 0 ? c.y + level.cells.y : c.y >= level.cells.y ? c.y - level.cells.y : c.y;
  c.y = c.y < 0 ? c.y + level.cells.y : c.y >= level.cells.y ? c.y - level.cells.y : c.y;
#endif
  return c;
}

// Returns true if the cell is in a block, so that it has weights.
bool isCovered(ivec2 c) {
  return c.x >= 0 && c.y >= 0 && (c.x >> 1) <= level.cells.x / 2 && (c.y >> 1) <= level.cells.y / 2;
}

bool isInside(ivec2 c) {
  return c.x >= 0 && c.y >= 0 && c.x < level.cells.x && c.y < level.cells.y;
}

int blockOf(ivec2 c) {
  return (c.y >> 1) * (level.cells.x / 2 + 1) + (c.x >> 1);
}

float cellOf(vec4 four, ivec2 c) {
  return (c.y & 1) == 0 ? ((c.x & 1) == 0 ? four.x : four.y) : ((c.x & 1) == 0 ? four.z : four.w);
}

uint wordOf(uvec4 four, ivec2 c) {
  return (c.y & 1) == 0 ? ((c.x & 1) == 0 ? four.x : four.y) : ((c.x & 1) == 0 ? four.z : four.w);
}

vec2 facesOf(ivec2 c) {
  if (!isCovered(c)) return vec2(0.0);
  return faceWeights(wordOf(LOAD_INPUT_WORDS(weights, level.weights + blockOf(c)), c));
}

// Returns the face weights of a cell inside the grid: left, right, top, bottom.
vec4 weightsOf(ivec2 c) {
  vec2 own = facesOf(c);
  return vec4(own.x, facesOf(c + ivec2(1, 0)).x, own.y, facesOf(c + ivec2(0, 1)).y);
}

float inPool(int start, ivec2 c) {
  if (!isInside(c)) return 0.0;
  return cellOf(LOAD_INPUT(pool, start + blockOf(c)), c);
}

// Returns a cell's correction. Outside the grid it is 0, because beyond open sides the correction is 0.
float inRaised(int start, ivec2 c) {
  if (!isInside(c)) return 0.0;
  return cellOf(LOAD_INPUT(raisedPool, start + blockOf(c)), c);
}

#include "fluid/tiles.glsl"
#if IN_THE_OPEN == 2
// Returns true if this workgroup processes open tiles. One dispatch processes both tile lists. The workgroups of the
// other tiles come first, because they take longer.
bool inTheOpen() {
  return int(gl_WorkGroupID.y) >= level.otherRows;
}
ivec2 blockHere() {
  return blockHere(inTheOpen() ? level.openTiles - groupRow * level.otherRows : level.otherTiles);
}
#else
bool inTheOpen() {
  return IN_THE_OPEN == 1;
}
ivec2 blockHere() {
  return blockHere(IN_THE_OPEN == 1 ? level.openTiles : level.otherTiles);
}
#endif

// Returns the tile of a workgroup that processes only one tile, or a tile beyond the grid if the list has no more
// tiles.
#ifdef TILE_A_GROUP
ivec2 tileHere() {
  int number = groupNumber();
  uint tile = LOAD_INPUT_WORDS(weights, level.otherTiles + (number >> 2))[number & 3];
  return ivec2(tile & 0xffffu, tile >> 16u);
}
#endif

#if IN_THE_OPEN != 0
// Variants of neighbours(), relaxed(), begun() and residual() for a cell whose weights are all 1.
float aroundOpen(float left, float right, float top, float bottom) {
  precise float sum = (left + right) + (top + bottom);
  return sum;
}

float relaxedOpen(float rhs, float sum) {
  return relaxed(rhs, sum, 4.0);
}

float begunOpen(float rhs) {
  return begun(rhs, 4.0);
}

float residualOpen(float rhs, float value, float left, float right, float top, float bottom) {
  precise float rest = rhs - (((value - left) + (value - right)) + ((value - top) + (value - bottom)));
  return exactFlush(rest);
}

#endif

bool isRed(ivec2 c) {
  return ((c.x + c.y) & 1) == 0;
}

// Common inputs of the fluid kernels, and the memory layout of cells: rows of size.x + 2 elements, starting with the
// ring's first row. A kernel that binds the carried flow, the dye or the next dye defines READS_CARRIED, READS_DYE or
// NEXT_DYE. LEFT, RIGHT, TOP and BOTTOM are the kinds of the sides.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"

layout(std140, binding = stepBinding) uniform FluidBlock { FluidStep stepData; };
uniform ivec2 size;  // Number of cells per axis
const int leftKind = LEFT, rightKind = RIGHT, topKind = TOP, bottomKind = BOTTOM;
const bool heats = HEATS == 1, viscous = VISCOUS == 1, confines = CONFINES == 1, sinks = SINKS == 1;
const bool secondOrder = ADVECTION == 0, cubic = ADVECTION == 2, obstacles = OBSTACLES == 1, obstaclesSlip = OBSTACLES_SLIP == 1;
const bool obstaclesMove = OBSTACLES_MOVE == 1, pocketsGrow = POCKETS_GROW == 1;
layout(std140, binding = solidsBinding) uniform SolidBlock { FluidSolidSet solidSet; };
// Index of the element in `weights` at which the words of solidWord() start; they are in blocks of 2x2 cells, like the
// face openings
uniform int solidsStart;

int elementOf(int x, int y) {
  return (y + 1) * (size.x + 2) + x + 1;
}

// Memory layout. On the texel path, a cell is one element of four floats. On the storage path, each quantity has its
// own plane (all u, then all v, and so on), so that neighbouring invocations load neighbouring words. Planes that would
// hold nothing are omitted (src/sim/fluid/arrays.hpp): the flow has u, v, temperature and pressure; the unprojected
// flow of a step has u, v and temperature; dye has three colours. The pressure plane is not moved during a step;
// kept.glsl stores the fraction of the pressure that remains.
int planeSize() {
  return (size.x + 2) * (size.y + 2);
}

#ifdef TEXEL_PATH
#define CELL_INPUT(unit, block, name) INPUT_ARRAY(unit, block, name)
#define LOAD_CELL(name, element) LOAD_INPUT(name, element)
#else
#define CELL_INPUT(unit, block, name) layout(std430, binding = unit) readonly restrict buffer block { float name[]; };
#define LOAD_CELL(name, element) vec4(name[element], name[planeSize() + (element)], name[2 * planeSize() + (element)], 0.0)
#endif

// NEXT_FLOW: the kernel writes the next flow. PRESSURE_APART: the flow that the kernel reads has no pressure plane, and
// the pressure is in the buffer of the next flow. FLOW_IN_PLACE: the kernel modifies the flow that it reads.
#if defined TEXEL_PATH || !defined FLOW_IN_PLACE
CELL_INPUT(flowBinding, FlowBlock, flow)
#else
layout(std430, binding = flowBinding) restrict buffer FlowBlock { float flow[]; };
#endif
#ifdef NEXT_FLOW
#ifdef TEXEL_PATH
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)
void storeNext(int x, int y, vec4 cell) {
  STORE_STATE(nextFlow, elementOf(x, y), cell);
}
#else
layout(std430, binding = nextFlowBinding) restrict buffer NextBlock { float nextFlow[]; };
void storeNext(int x, int y, vec4 cell) {
  int i = elementOf(x, y);
  nextFlow[i] = cell.x;
  nextFlow[planeSize() + i] = cell.y;
  nextFlow[2 * planeSize() + i] = cell.z;
}
#endif
#endif

#ifdef TEXEL_PATH
vec4 flowIn(int element) {
  return LOAD_INPUT(flow, element);
}
#else
#ifdef READS_KEPT
#include "fluid/kept.glsl"
#endif
float pressureIn(int element) {
#ifdef PRESSURE_APART
  float pressure = nextFlow[3 * planeSize() + element];
#else
  float pressure = flow[3 * planeSize() + element];
#endif
#ifdef READS_KEPT
  pressure = keptOf(pressure);
#endif
  return pressure;
}
vec4 flowIn(int element) {
  return vec4(flow[element], flow[planeSize() + element], flow[2 * planeSize() + element], pressureIn(element));
}
#endif
vec4 flowAt(int x, int y) {
  return flowIn(elementOf(x, y));
}

#ifdef READS_CARRIED
CELL_INPUT(carriedBinding, CarriedBlock, carried)
vec4 carriedAt(int x, int y) {
  return LOAD_CELL(carried, elementOf(x, y));
}
#else
vec4 carriedAt(int x, int y) {
  return vec4(0.0);
}
#endif

// dyeAt() accepts cells up to two cells outside the grid. On a periodic axis it returns the cell on the opposite side,
// otherwise the nearest cell of the ring (the one row or column of cells stored around the grid).
#ifdef READS_DYE
CELL_INPUT(dyeBinding, DyeBlock, dye)
vec4 dyeAt(int x, int y) {
  int i = LEFT == periodicSide ? (x < 0 ? x + size.x : x >= size.x ? x - size.x : x) : clamp(x, -1, size.x);
  int j = TOP == periodicSide ? (y < 0 ? y + size.y : y >= size.y ? y - size.y : y) : clamp(y, -1, size.y);
  return LOAD_CELL(dye, elementOf(i, j));
}
#else
vec4 dyeAt(int x, int y) {
  return vec4(0.0);
}
#endif
#ifdef NEXT_DYE
#ifdef TEXEL_PATH
STATE_ARRAY(nextDyeBinding, NextDyeBlock, nextDye)
void storeDye(int element, vec4 value) {
  STORE_STATE(nextDye, element, value);
}
#else
layout(std430, binding = nextDyeBinding) writeonly restrict buffer NextDyeBlock { float nextDye[]; };
void storeDye(int element, vec4 value) {
  nextDye[element] = value.x;
  nextDye[planeSize() + element] = value.y;
  nextDye[2 * planeSize() + element] = value.z;
}
#endif
#endif

// Face openings (faceWeights in model.glsl), one block of 2x2 cells per element. The finest level has blocks for size.x
// + 1 columns, because the far border also has faces.
INPUT_WORDS(weightsBinding, WeightBlock, weights)
uint wordOf(uvec4 four, int x, int y) {
  return (y & 1) == 0 ? ((x & 1) == 0 ? four.x : four.y) : ((x & 1) == 0 ? four.z : four.w);
}

uint solidWord(int x, int y) {
#if OBSTACLES == 1
  return wordOf(LOAD_INPUT_WORDS(weights, solidsStart + (y >> 1) * (size.x / 2 + 1) + (x >> 1)), x, y);
#else
  return 0xffffu;
#endif
}

vec2 faceAt(int x, int y) {
  return faceWeights(wordOf(LOAD_INPUT_WORDS(weights, (y >> 1) * (size.x / 2 + 1) + (x >> 1)), x, y));
}

// Sum of the pressure corrections in `pool`, in the same blocks of 2x2 cells, followed by the rounding error of the
// sum. sumAt() returns both.
#ifdef READS_SUM
INPUT_ARRAY(carriedBinding, PoolBlock, pool)
vec2 sumAt(int x, int y) {
  int i = LEFT == periodicSide ? (x < 0 ? x + size.x : x) : x;
  int j = TOP == periodicSide ? (y < 0 ? y + size.y : y) : y;
  if (i < 0 || j < 0 || i >= size.x || j >= size.y) return vec2(0.0);
  int block = (j >> 1) * (size.x / 2 + 1) + (i >> 1);
  vec4 sums = LOAD_INPUT(pool, block), lost = LOAD_INPUT(pool, (size.x / 2 + 1) * (size.y / 2 + 1) + block);
  return (j & 1) == 0 ? ((i & 1) == 0 ? vec2(sums.x, lost.x) : vec2(sums.y, lost.y))
                      : ((i & 1) == 0 ? vec2(sums.z, lost.z) : vec2(sums.w, lost.w));
}
#else
vec2 sumAt(int x, int y) {
  return vec2(0.0);
}
#endif
#include "fluid/transport.glsl"
// projected.glsl needs transport.glsl.
#include "fluid/projected.glsl"

// What a fluid's kernels read, and how its cells lie in memory: rows of size.x + 2 elements, the ring's first. Before
// including: READS_CARRIED and READS_DYE where those are bound. The sides' kinds are LEFT, RIGHT, TOP, BOTTOM.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"

layout(std140, binding = stepBinding) uniform FluidBlock { FluidStep stepData; };
uniform ivec2 size;  // cells
const int leftKind = LEFT, rightKind = RIGHT, topKind = TOP, bottomKind = BOTTOM;
const bool heats = HEATS == 1, viscous = VISCOUS == 1, confines = CONFINES == 1, sinks = SINKS == 1;
const bool secondOrder = ADVECTION == 0, cubic = ADVECTION == 2, obstacles = OBSTACLES == 1, obstaclesSlip = OBSTACLES_SLIP == 1;
const bool obstaclesMove = OBSTACLES_MOVE == 1, pocketsGrow = POCKETS_GROW == 1;
layout(std140, binding = solidsBinding) uniform SolidBlock { FluidSolidSet solidSet; };
uniform int solidsStart;  // elements: where in `weights` the words of solidWord are, in blocks as faces

int elementOf(int x, int y) {
  return (y + 1) * (size.x + 2) + x + 1;
}

// Between the kernels of a step, of storage blocks: all u, then all v and so on (PLANES_IN, PLANES_OUT), so that neighbouring
// invocations load neighbouring words.
#if defined PLANES_IN && !defined TEXEL_PATH
#define PLANE_ARRAY(unit, block, name) layout(std430, binding = unit) readonly restrict buffer block { float name[]; };
PLANE_ARRAY(flowBinding, FlowBlock, flow)
vec4 flowAt(int x, int y) {
  int i = elementOf(x, y), plane = (size.x + 2) * (size.y + 2);
  return vec4(flow[i], flow[plane + i], flow[2 * plane + i], flow[3 * plane + i]);
}
#else
INPUT_ARRAY(flowBinding, FlowBlock, flow)
vec4 flowAt(int x, int y) {
  return LOAD_INPUT(flow, elementOf(x, y));
}
#endif

#ifdef PLANES_OUT
#ifdef TEXEL_PATH
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)
void storeNext(int x, int y, vec4 cell) {
  STORE_STATE(nextFlow, elementOf(x, y), cell);
}
#else
layout(std430, binding = nextFlowBinding) writeonly restrict buffer NextBlock { float nextFlow[]; };
void storeNext(int x, int y, vec4 cell) {
  int i = elementOf(x, y), plane = (size.x + 2) * (size.y + 2);
  nextFlow[i] = cell.x;
  nextFlow[plane + i] = cell.y;
  nextFlow[2 * plane + i] = cell.z;
  if (PLANES_OUT == 4) nextFlow[3 * plane + i] = cell.w;
}
#endif
#endif

#ifdef READS_CARRIED
#ifdef PLANE_ARRAY
PLANE_ARRAY(carriedBinding, CarriedBlock, carried)
vec4 carriedAt(int x, int y) {
  int i = elementOf(x, y), plane = (size.x + 2) * (size.y + 2);
  return vec4(carried[i], carried[plane + i], carried[2 * plane + i], 0.0);
}
#else
INPUT_ARRAY(carriedBinding, CarriedBlock, carried)
vec4 carriedAt(int x, int y) {
  return LOAD_INPUT(carried, elementOf(x, y));
}
#endif
#else
vec4 carriedAt(int x, int y) {
  return vec4(0.0);
}
#endif

// Two cells beyond the border, too: there what follows on a torus, else the ring.
#ifdef READS_DYE
INPUT_ARRAY(dyeBinding, DyeBlock, dye)
vec4 dyeAt(int x, int y) {
  int i = LEFT == periodicSide ? (x < 0 ? x + size.x : x >= size.x ? x - size.x : x) : clamp(x, -1, size.x);
  int j = TOP == periodicSide ? (y < 0 ? y + size.y : y >= size.y ? y - size.y : y) : clamp(y, -1, size.y);
  return LOAD_INPUT(dye, elementOf(i, j));
}
#else
vec4 dyeAt(int x, int y) {
  return vec4(0.0);
}
#endif

// Blocks of 2x2 cells an element, their openings (model.glsl: faceWeights); of the finest level those of size.x + 1
// columns, for there are faces at the far border, too.
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

// The sum of corrections lies in `pool` in such blocks, too, then what rounding took from it.
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
// What transport.glsl has comes first.
#include "fluid/projected.glsl"

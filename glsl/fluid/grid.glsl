// What a fluid's kernels read, and how its cells lie in memory: rows of size.x + 2 elements, the ring's first. Before
// including: READS_CARRIED, READS_DYE and NEXT_DYE where those are bound. The sides' kinds are LEFT, RIGHT, TOP, BOTTOM.
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

// Arrays of texels hold an element of four floats a cell. Those of storage blocks hold all u, then all v and so on, so that
// neighbouring invocations load neighbouring words, and no more of these planes than there is something in
// (src/sim/fluid/arrays.hpp): the flow u, v, temperature and pressure; what a step makes of it before it is projected the first
// three, and the pressure stays where it is, of which `kept` (kept.glsl) is left until then; dye its three colours.
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

// Before including: NEXT_FLOW where a kernel makes flow, PRESSURE_APART where what it reads has no pressure with it, that being
// where the next flow will be; FLOW_IN_PLACE where it changes what it reads.
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

// Two cells beyond the border, too: there what follows on a torus, else the ring.
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

// Computes one step of the fire. EMBERS: embers fly ahead of the fire. SLOPE: the fire spreads faster uphill. GALES:
// the wind comes from a fluid.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "spread/rows.glsl"
#include "spread/wildfire/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { WildfireStep stepData; };
INPUT_WORDS(fuelsBinding, FuelBlock, fuels)     // Flammability of each cell, one byte per cell
INPUT_WORDS(groundBinding, GroundBlock, ground)  // One byte per cell: the ground's shade, 0 to 15, plus 16 times its
                                                 // cooling phase
#ifdef SLOPE
INPUT_WORDS(inclinesBinding, InclineBlock, inclines)  // Incline of each cell: two bytes in the format of climbed()
INPUT_ARRAY(climbsBinding, ClimbBlock, climbs)
float climbFactor(int i) {
  return LOAD_INPUT(climbs, i >> 2)[i & 3];
}
#else
float climbFactor(int i) { return 1.0f; }
#endif
#include "spread/wildfire/gale.glsl"
#include "spread/wildfire/model.glsl"
#ifdef GALES
INPUT_WORDS(galesBinding, GaleBlock, gales)  // Gales, one word per cell
uint galeOn(int place, int k) {
  return LOAD_INPUT_WORDS(gales, 4 * place + (k >> 2))[k & 3];
}
#endif

struct Rates {
  uvec4 spread[2];
  uint burnSteps, firstPhase, phases;
  uint emberThreshold, step, seed;
  Draw draw;
};

Rates ratesNow() {
  return Rates(stepData.spread, uint(stepData.constants.burnSteps), stepData.firstPhase, stepData.phases,
               stepData.emberThreshold, stepData.step, stepData.seed, drawOf(stepData.step, stepData.seed));
}

#ifdef EMBERS
// Returns the index of the cell in this element that an ember hits in this step, or -1. At most one of the sixteen
// cells is tested. The cell from which the ember comes must burn.
int emberTarget(Rates rates, Column column, int y) {
  uvec3 random = hash3(uvec3(uint(placeIn(column, y)), rates.step, rates.seed ^ 0x5bd1e995u));
  if (random.x >> 5u >= rates.emberThreshold) return -1;
  int k = int(random.x & 15u);
#ifdef GALES
  ivec2 longest = galeFlight(galeOn(placeIn(column, y), k));
#else
  ivec2 longest = stepData.emberFlight;
#endif
  ivec2 from = ivec2(16 * column.here + k, y) - emberFlight(random, longest);
  if (column.torus) from = (from + 1024 * column.size) % column.size;
  if (any(lessThan(from, ivec2(0))) || any(greaterThanEqual(from, column.size))) return -1;
  uvec4 there = LOAD_INPUT_WORDS(cells, from.y * column.rowElements + (from.x >> 4));
  return (byteOf(there, from.x & 15) & classMask) == classActive ? k : -1;
}
#endif

// Computes the next state of sixteen cells in parallel, like nextBurning() and nextBurnt().
uvec4 grownOlder(Rates rates, Row here, uvec4 shade) {
  uvec4 old = (here.state & 0x3f3f3f3fu) + ones * (129u - rates.burnSteps);  // Bit 7 is set if the cell burns out in
                                                                             // this step.
  uvec4 burning = isActive(here);
  uvec4 done = burning & (old >> 7u);
  uvec4 isDone = done * 255u;
  uvec4 ash = 0xc0c0c0c0u | (shade >> 1u & 0x07070707u);
  uvec4 next = ((here.state + (burning ^ done)) & ~isDone) | (ash & isDone);

  uvec4 wait = ((shade >> 4u & 0x0f0f0f0fu) + ones * (16u - rates.firstPhase)) & 0x0f0f0f0fu;
  uvec4 turn = ~(((wait | 0x80808080u) - ones * rates.phases) >> 7u);
  uvec4 cold = here.state >> 3u & here.state >> 4u & here.state >> 5u;
  return next + ((spentCells(here.state) & turn & ~cold) << 3u);
}

// Burnt cells also change without an active neighbour, because they cool.
uvec4 restlessCells(uvec4 state) {
  uvec4 cold = state >> 3u & state >> 4u & state >> 5u;
  return spentCells(state) & ~cold;
}

// Returns true if an ember can ignite fuel anywhere.
bool changesAlone(Rates rates, uvec4 counts) {
  return rates.emberThreshold != 0u && (counts.x & 0xffffu) != 0u;
}

#if !defined(SLOPE) && !defined(GALES)
// Returns catchChance() for even ground and uniform wind.
uint evenChance(uint burning, uint fuel, uvec4 spread[2]) {
  uint p = 0u;
  for (uint d = 0u; d < 8u; ++d) {
    uint t = (0u - (burning >> d & 1u)) & spread[d >> 2u][d & 3u];
    t = (t * fuel) >> 8u;
    p = t + (((p - (p >> 16u)) * (65536u - t)) >> 16u);
  }
  return p;
}
#endif

// The loop visits only the cells that can ignite; usually they are few of the sixteen.
uvec4 stepElement(Rates rates, Column column, int y, Row above, Row here, Row below) {
  uvec4 burning = above.near | leftActive(here) << 3u | rightActive(here) << 4u | below.near << 5u;
  uvec4 touched = burning | burning >> 1u | burning >> 2u | burning >> 3u;
  touched = (touched | touched >> 4u) & readyCells(here.state);
  int place = placeIn(column, y);
  uvec4 next = grownOlder(rates, here, LOAD_INPUT_WORDS(ground, place));
  int hit = -1;
#ifdef EMBERS
  hit = emberTarget(rates, column, y);
  if (hit >= 0 && (byteOf(here.state, hit) & classMask) != classReady) hit = -1;
#endif
  uint todo = bitsOf(touched);
  if (hit >= 0) todo |= 1u << uint(hit);
  if (todo == 0u) return next;
  uvec4 fuel = LOAD_INPUT_WORDS(fuels, place);
  uint first = cellsOf(column, y).x;
#ifdef SLOPE
  uvec4 leftSteep = LOAD_INPUT_WORDS(inclines, 2 * place);
  uvec4 rightSteep = LOAD_INPUT_WORDS(inclines, 2 * place + 1);
#endif
  for (; todo != 0u; todo &= todo - 1u) {
    int k = findLSB(todo);
    uint random = spreadRandoms(uvec4(first + uint(k)), rates.draw).x;
    uint weight = fuelWeight(byteOf(fuel, k));
#if defined(SLOPE) || defined(GALES)
    uint incline = evenGround, gale = stillAir;
#ifdef SLOPE
    uint pair = k < 8 ? leftSteep[k >> 1 & 3] : rightSteep[k >> 1 & 3];
    incline = pair >> uint(16 * (k & 1)) & 0xffffu;
#endif
#ifdef GALES
    gale = galeOn(place, k);
#endif
    bool caught = random >> 15u < catchChance(byteOf(burning, k), weight, incline, gale);
#else
    bool caught = random >> 15u < evenChance(byteOf(burning, k), weight, rates.spread);
#endif
#ifdef EMBERS
    if (k == hit && (random & 255u) < weight) caught = true;
#endif
    if (caught) setByte(next, k, classActive);
  }
  return next;
}
#include "spread/step.glsl"

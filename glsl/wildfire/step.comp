// One step of the fire. EMBERS: sparks that fly ahead.
#include "spread/rows.glsl"
#include "wildfire/types.glsl"
layout(std140, binding = 0) uniform StepBlock { WildfireStep stepData; };
INPUT_WORDS(2, FuelBlock, fuels)     // bytes: how readily a cell burns
INPUT_WORDS(3, GroundBlock, ground)  // bytes: the ground's shade, 0 to 15
#include "wildfire/model.glsl"

#ifdef EMBERS
// In each step one cell of the sixteen may be hit by an ember, if its place of origin burns.
int emberTarget(ivec2 at) {
  uint group = uint(at.y) * uint(rowElements()) + uint(at.x);
  uvec3 random = hash3(uvec3(group, stepData.numbers.x, stepData.numbers.y ^ 0x5bd1e995u));
  if (random.x >> 5u >= uint(stepData.embers.w)) return -1;
  int k = int(random.x & 15u);
  ivec2 from = ivec2(16 * at.x + k, at.y) - emberFlight(random);
  if (torus) from = (from + 1024 * size) % size;
  if (any(lessThan(from, ivec2(0))) || any(greaterThanEqual(from, size))) return -1;
  uvec4 there = LOAD_INPUT_WORDS(cells, from.y * rowElements() + (from.x >> 4));
  return (byteOf(there, from.x & 15) & classMask) == classActive ? k : -1;
}
#endif

// A loop over the cells to which something may happen: mostly few of the sixteen.
uvec4 stepElement(ivec2 at, Row above, Row here, Row below) {
  uvec4 ready = readyCells(here.state);
  uvec4 burning = above.left | above.here << 1u | above.right << 2u | here.left << 3u | here.right << 4u |
                  below.left << 5u | below.here << 6u | below.right << 7u;
  uvec4 next = here.state;
  uvec4 touched = burning | burning >> 1u | burning >> 2u | burning >> 3u;
  touched = (touched | touched >> 4u) & ones;
  uvec4 hot = spentCells(here.state) & ~((here.state >> 3u) & (here.state >> 4u) & (here.state >> 5u));
  uint todo = bitsOf((ready & touched) | here.here | hot);
#ifdef EMBERS
  int hit = emberTarget(at);
  if (hit >= 0) todo |= 1u << uint(hit);
#endif
  if (todo == 0u) return next;
  int place = at.y * rowElements() + at.x;
  uvec4 fuel = LOAD_INPUT_WORDS(fuels, place);
  uvec4 shade = LOAD_INPUT_WORDS(ground, place);
  uint first = uint(at.y) * uint(size.x) + uint(16 * at.x);
  for (; todo != 0u; todo &= todo - 1u) {
    int k = findLSB(todo);
    uint cell = byteOf(here.state, k);
    uint kind = cell & classMask;
    uint random = spreadRandom(first + uint(k), stepData.numbers.x, stepData.numbers.y);
    uint weight = fuelWeight(byteOf(fuel, k));
    uint result = cell;
    if (kind == classReady) {
      bool caught = random >> 15u < catchChance(byteOf(burning, k), weight);
#ifdef EMBERS
      if (k == hit && (random & 255u) < weight) caught = true;
#endif
      if (caught) result = classActive;
    } else if (kind == classActive) {
      result = nextBurning(cell, byteOf(shade, k));
    } else if (kind == classSpent) {
      result = nextBurnt(cell, random);
    }
    setByte(next, k, result);
  }
  return next;
}
#include "spread/step.glsl"

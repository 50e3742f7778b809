// Computes one step of the epidemic. If MIXED is defined, cells are infected from the whole grid, otherwise from their
// eight neighbours.
#include "spread/rows.glsl"
#include "spread/epidemic/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { EpidemicStep stepData; };
#include "spread/epidemic/model.glsl"

struct Rates {
  uvec4 infection[3];
  uint recovery, waning;
  bool ageing;
  Draw draw;
};

Rates ratesNow() {
  return Rates(stepData.infection, stepData.recovery, stepData.waning, stepData.ageing != 0u,
               drawOf(stepData.step, stepData.seed));
}

// Spent cells also change without an active neighbour, because they age.
uvec4 restlessCells(uvec4 state) {
  uvec4 old = (state & 0x3f3f3f3fu) + ones;  // Bit 6 is set if the age was 63
  return spentCells(state) & ~(old >> 6u);
}

// Returns true if cells can lose their immunity, or can be infected from anywhere (MIXED).
bool changesAlone(Rates rates, uvec4 counts) {
#ifdef MIXED
  if ((counts.x & 0xffffu) != 0u) return true;
#endif
  return rates.waning != 0u && counts.z != 0u;
}

// Looks up the thresholds for the counts n. On the texel path, the bits of n select the value, because a lookup with
// different indices per lane would be serialized.
uvec4 thresholdsFor(uvec4 n, uvec4 table[3]) {
#ifdef TEXEL_PATH
  bvec4 one = notEqual(n & 1u, uvec4(0u)), two = notEqual(n & 2u, uvec4(0u)), four = notEqual(n & 4u, uvec4(0u));
  uvec4 a = table[0], b = table[1];
  uvec4 upTo3 = mix(mix(uvec4(a.x), uvec4(a.y), one), mix(uvec4(a.z), uvec4(a.w), one), two);
  uvec4 upTo7 = mix(mix(uvec4(b.x), uvec4(b.y), one), mix(uvec4(b.z), uvec4(b.w), one), two);
  return mix(mix(upTo3, upTo7, four), uvec4(table[2].x), greaterThan(n, uvec4(7u)));
#else
  uvec4 found;
  for (int i = 0; i < 4; ++i) found[i] = stepData.infection[n[i] >> 2u][n[i] & 3u];
  return found;
#endif
}

// Computes the next state of four cells like nextPerson(). If the random number is below the threshold, a cell moves to
// the next class, and from the last class to the first.
uvec4 nextPersons(uvec4 before, uvec4 infection, uint recovery, uint waning, uvec4 random) {
  uvec4 kind = before & classMask;
  uvec4 threshold = mix(infection, uvec4(recovery), equal(kind, uvec4(classActive)));
  threshold = mix(threshold, uvec4(waning), equal(kind, uvec4(classSpent)));
  uvec4 onward = mix(kind + 64u, uvec4(classReady), equal(kind, uvec4(classSpent)));
  bvec4 changes = lessThan(random, mix(threshold, uvec4(0u), equal(kind, uvec4(classNobody))));
  return mix(before, onward, changes);
}

// The loop visits the byte positions at which at least one of the four words has a cell that can change; usually there
// are few.
uvec4 stepElement(Rates rates, Column column, int y, Row above, Row here, Row below) {
  uvec4 ready = readyCells(here.state);
  uvec4 infected = leftActive(above) + isActive(above) + rightActive(above) + leftActive(here) + rightActive(here) +
                   leftActive(below) + isActive(below) + rightActive(below);
  uvec4 next = rates.ageing ? aged(here.state) : here.state;
#ifdef MIXED
  uvec4 everywhere = uvec4(mixedThreshold(counts[4 * countPlace - 3]));
  uvec4 drawn = ready | isActive(here);
#else
  uvec4 drawn = (ready & notZero(infected)) | isActive(here);
#endif
  if (rates.waning != 0u) drawn |= spentCells(here.state);
  uvec4 cells = cellsOf(column, y);
  uint todo = drawn.x | drawn.y | drawn.z | drawn.w;
#ifdef MIXED
#define THRESHOLD(place) everywhere
#else
#define THRESHOLD(place) thresholdsFor(infected >> place & 15u, rates.infection)
#endif
#define STEP_PLACE(place)                                                                                   \
  uvec4 before = next >> place & 255u;                                                                      \
  uvec4 random = spreadRandoms(cells + (place >> 3u), rates.draw);                                          \
  next ^= (before ^ nextPersons(before, THRESHOLD(place), rates.recovery, rates.waning, random)) << place;
#ifdef TEXEL_PATH
  // The lanes of a software driver execute together. The loop therefore visits all byte positions, or none if no lane
  // has a cell that can change.
  for (; todo != 0u; todo = 0u)
    for (uint place = 0u; place < 32u; place += 8u) {
      STEP_PLACE(place)
    }
#else
  for (; todo != 0u; todo &= todo - 1u) {
    uint place = uint(findLSB(todo));
    STEP_PLACE(place)
  }
#endif
  return next;
}
#include "spread/step.glsl"

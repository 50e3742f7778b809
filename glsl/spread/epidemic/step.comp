// One step of the epidemic. MIXED: everyone meets everyone; else the eight neighbours.
#include "spread/rows.glsl"
#include "spread/epidemic/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { EpidemicStep stepData; };
#include "spread/epidemic/model.glsl"

uint thresholdFor(uint n) { return stepData.infection[n >> 2u][n & 3u]; }

// A loop over the places in a word where something may happen to one of the four cells there: mostly few.
uvec4 stepElement(ivec2 at, Row above, Row here, Row below) {
  uvec4 ready = readyCells(here.state);
  uvec4 infected = above.left + above.here + above.right + here.left + here.right + below.left + below.here + below.right;
  uvec4 next = stepData.ageing != 0u ? aged(here.state) : here.state;
#ifdef MIXED
  uint everywhere = mixedThreshold(counts[4 * countPlace - 3]);
  uvec4 drawn = ready | here.here;
#else
  uvec4 drawn = (ready & notZero(infected)) | here.here;
#endif
  if (stepData.waning != 0u) drawn |= spentCells(here.state);
  uint first = uint(at.y) * uint(size.x) + uint(16 * at.x);
  for (uint todo = drawn.x | drawn.y | drawn.z | drawn.w; todo != 0u; todo &= todo - 1u) {
    uint place = uint(findLSB(todo));
    uint cell = first + (place >> 3u);
    uvec4 before = next >> place & 255u;
#ifdef MIXED
    uvec4 threshold = uvec4(everywhere);
#else
    uvec4 n = infected >> place & 15u;
    uvec4 threshold = uvec4(thresholdFor(n.x), thresholdFor(n.y), thresholdFor(n.z), thresholdFor(n.w));
#endif
    uint step = stepData.step, seed = stepData.seed;
    uvec4 after = uvec4(nextPerson(before.x, threshold.x, spreadRandom(cell, step, seed)),
                        nextPerson(before.y, threshold.y, spreadRandom(cell + 4u, step, seed)),
                        nextPerson(before.z, threshold.z, spreadRandom(cell + 8u, step, seed)),
                        nextPerson(before.w, threshold.w, spreadRandom(cell + 12u, step, seed)));
    next ^= (before ^ after) << place;
  }
  return next;
}
#include "spread/step.glsl"

// One step of the epidemic. MIXED: everyone meets everyone; else the eight neighbours.
#include "spread/rows.glsl"
#include "epidemic/types.glsl"
layout(std140, binding = 0) uniform StepBlock { EpidemicStep stepData; };
#include "epidemic/model.glsl"

// A loop over the cells to which something may happen: mostly few of the sixteen.
uvec4 stepElement(ivec2 at, Row above, Row here, Row below) {
  uvec4 ready = readyCells(here.state);
  uvec4 infected = above.left + above.here + above.right + here.left + here.right + below.left + below.here + below.right;
  uvec4 next = stepData.numbers.z != 0u ? aged(here.state) : here.state;
#ifdef MIXED
  uint everywhere = mixedThreshold(counts[4 * countPlace - 3]);
  uvec4 drawn = ready | here.here;
#else
  uvec4 drawn = (ready & notZero(infected)) | here.here;
#endif
  if (stepData.infection[2].z != 0u) drawn |= spentCells(here.state);
  uint first = uint(at.y) * uint(size.x) + uint(16 * at.x);
  for (uint todo = bitsOf(drawn); todo != 0u; todo &= todo - 1u) {
    int k = findLSB(todo);
#ifdef MIXED
    uint threshold = everywhere;
#else
    uint n = byteOf(infected, k);
    uint threshold = stepData.infection[n >> 2u][n & 3u];
#endif
    uint random = spreadRandom(first + uint(k), stepData.numbers.x, stepData.numbers.y);
    setByte(next, k, nextPerson(byteOf(next, k), threshold, random));
  }
  return next;
}
#include "spread/step.glsl"

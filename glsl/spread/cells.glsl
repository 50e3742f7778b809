// Cells of what spreads from neighbour to neighbour, a byte each: the upper two bits are the class, the lower six a
// tone (classes 0 and 1) or an age in steps (2 and 3). Compiles as GLSL and as C++ (src/sim/spread/plan.hpp).
#ifndef SPREAD_CELLS
#define SPREAD_CELLS

const uint classNobody = 0u;     // 0x00: nothing ever happens here
const uint classReady = 64u;     // 0x40: can catch it
const uint classActive = 128u;   // 0x80: spreads it
const uint classSpent = 192u;    // 0xc0: had it
const uint classMask = 192u;
const uint certain = 0x80000000u;  // a threshold of 31-bit random numbers that every one of them is below

// A random number below `certain` for a cell in a step.
FUNCTION uint spreadRandom(uint cell, uint step, uint seed) {
  return hash3(uvec3(cell, step, seed)).x >> 1u;
}

#endif

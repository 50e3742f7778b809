// Cells of epidemics and wildfires, one byte each. The upper two bits are the class; the lower six bits are a tone
// (classes 0 and 1) or an age in steps (classes 2 and 3). Compiles as GLSL and as C++ (src/sim/spread/plan.hpp).
#ifndef SPREAD_CELLS
#define SPREAD_CELLS

const uint classNobody = 0u;     // 0x00: empty cell, which never changes
const uint classReady = 64u;     // 0x40: susceptible, or unburnt fuel
const uint classActive = 128u;   // 0x80: infected, or burning
const uint classSpent = 192u;    // 0xc0: recovered, or burnt
const uint classMask = 192u;
const uint certain = 0x80000000u;  // Threshold above all 31-bit random numbers

// Returns a random number below `certain` for a cell in a step.
FUNCTION uint spreadRandom(uint cell, uint step, uint seed) {
  return hash3(uvec3(cell, step, seed)).x >> 1u;
}

#endif

// Uniform block that the epidemic's kernels read once per step. Compiles as GLSL and as C++
// (src/sim/spread/epidemic_plan.hpp).
#ifndef EPIDEMIC_TYPES
#define EPIDEMIC_TYPES

struct STD140 EpidemicStep {
  uvec4 infection[3];   // Thresholds of infection for 0 to 8 infected neighbours
  uint recovery;        // Threshold of recovery; `waning` is the threshold of losing immunity
  uint waning;
  uint step;
  uint seed;
  uint ageing;          // 1 if ages increase in this step, otherwise 0
  float perInfected;    // beta / people, for global mixing
  float per4096;        // 4096 times `perInfected`
};

#endif

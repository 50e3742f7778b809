// What the epidemic's kernels read once per step. Compiles as GLSL and as C++ (src/sim/spread/epidemic_plan.hpp).
#ifndef EPIDEMIC_TYPES
#define EPIDEMIC_TYPES

struct STD140 EpidemicStep {
  uvec4 infection[3];   // thresholds of infection with 0 to 8 infected neighbours
  uint recovery;        // thresholds
  uint waning;
  uint step;
  uint seed;
  uint ageing;          // 1 where ages go on in this step
  float perInfected;    // everyone meets everyone: beta / people,
  float per4096;        // and 4096 times that
};

#endif

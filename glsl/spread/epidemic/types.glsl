// What the epidemic's kernels read once per step. Compiles as GLSL and as C++ (src/sim/spread/epidemic_plan.hpp). Only
// 16-byte members, so std140 and std430 agree.
#ifndef EPIDEMIC_TYPES
#define EPIDEMIC_TYPES

struct EpidemicStep {
  uvec4 infection[3];  // thresholds of infection with 0 to 8 infected neighbours; then of recovery and of waning, 0
  uvec4 numbers;       // step, seed, whether ages go on, 0
  vec4 mixing;         // everyone meets everyone: beta / people, 4096 times that, 0, 0
};

#endif

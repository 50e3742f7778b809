// Uniforms and binding points of the tracer kernels. Compiles as GLSL and as C++ (src/sim/fluid/tracers.hpp).
#ifndef TRACER_TYPES
#define TRACER_TYPES
const int tracersBinding = 0;
const int solidBinding = 1;  // One bit per cell
const int trailBinding = 2;  // One word per cell, in a storage buffer if the kernel writes it, otherwise in a texel
                             // buffer
const int shownBinding = 3;

struct TracerStep {
  float dt;       // Duration of a substep in seconds
  float seconds;  // Mean lifetime in seconds
  int seed;
  int wrapsX;     // 1 if the grid is periodic along x
  int wrapsY;
};
#endif

// What tracers are told; plain uniforms. Compiles as GLSL and as C++ (src/sim/fluid/tracers.hpp).
#ifndef TRACER_TYPES
#define TRACER_TYPES
const int tracersBinding = 0;
const int solidBinding = 1;  // a bit a cell
const int trailBinding = 2;  // a word a cell, as storage; as words to be read
const int shownBinding = 3;

struct TracerStep {
  float dt;       // s
  float seconds;  // mean life
  int seed;
  int wrapsX;     // 1: the grid is a torus that way
  int wrapsY;
};
#endif

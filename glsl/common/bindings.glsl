// Where every simulation has these. Compiles as GLSL and, by common/cpp.hpp, as C++.
#ifndef COMMON_BINDINGS
#define COMMON_BINDINGS

const int stepBinding = 0;    // of uniform blocks: what a step is told
const int statusBinding = 7;  // of storage blocks: status.glsl

#endif

// What every simulation has, and the kernels of this folder. Compiles as GLSL and, by common/cpp.hpp, as C++.
#ifndef COMMON_BINDINGS
#define COMMON_BINDINGS

const int stepBinding = 0;     // of uniform blocks: what a step is told
const int statusBinding = 7;   // of storage blocks: status.glsl
const int wordsBinding = 0;    // of textures: what is hashed
const int sumsBinding = 0;     // of storage blocks: the hashes' sums
const int planesBinding = 1;   // of storage blocks: what is hashed, where it lies in planes
const int inputsBinding = 0;   // of storage blocks: a probe's
const int outputsBinding = 1;

#endif

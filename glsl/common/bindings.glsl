// Binding points used by all simulations and by the kernels in glsl/common. Compiles as GLSL and, through
// common/cpp.hpp, as C++.
#ifndef COMMON_BINDINGS
#define COMMON_BINDINGS

const int stepBinding = 0;     // uniform block: parameters of a simulation step
const int statusBinding = 7;   // storage block: status.glsl
const int wordsBinding = 0;    // texture: words to hash
const int sumsBinding = 0;     // storage block: sums of hashes
const int planesBinding = 1;   // storage block: words to hash, if they are stored in planes (state_words.glsl)
const int inputsBinding = 0;   // storage blocks of probe.comp and loop_probe.comp: inputs and outputs
const int outputsBinding = 1;

#endif

// Number of passes against thin colliders per substep. Compiles as GLSL and as C++ (src/sim/cloth/thin.cpp).
#ifndef CLOTH_THIN_ROUNDS
#define CLOTH_THIN_ROUNDS

const int thinRounds = 4;

#endif

// Binding points of the skinning kernel. Compiles as GLSL and as C++ (src/sim/body/skinned_surface.cpp).
#ifndef BODY_BINDINGS
#define BODY_BINDINGS

const int restPositionsBinding = 0;
const int restNormalsBinding = 1;
const int followBinding = 2;
const int weightsBinding = 3;
const int posesBinding = 4;
const int positionsBinding = 5;
const int normalsBinding = 6;

#endif

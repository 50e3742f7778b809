#ifndef FLOAT_BINDINGS
#define FLOAT_BINDINGS

// Binding 0 holds the water's cells: cellsBinding of water/bindings.glsl.
const int floatsBinding = 1;
const int nextFloatsBinding = 2;
const int floatParametersBinding = 3;
const int floatPointsBinding = 4;
const int floatSumsBinding = 5;
const int hullPositionsBinding = 3;
const int hullNormalsBinding = 4;
const int placedPositionsBinding = 5;
const int placedNormalsBinding = 6;

#endif

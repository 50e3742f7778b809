// Binding points of the arrays of the cloth kernels. Some kernels reuse a binding point for different arrays.
#ifndef CLOTH_BINDINGS
#define CLOTH_BINDINGS

const int positionsBinding = 0;
const int nextPositionsBinding = 1;
const int velocitiesBinding = 2;
const int shiftsBinding = 3;  // Used by thin.comp and shift.comp
const int aimsBinding = 3;    // Used by relax.comp and constrain_lines.comp: velocities before constraints
const int trendsBinding = 5;
const int leftBinding = 5;    // Used by settle.comp
const int waysBinding = 5;    // Used by hold.comp
const int colorsBinding = 1;  // Used by color.comp, like the following binding points
const int beforeBinding = 3;
const int stopsBinding = 4;
const int verticesBinding = 6;
const int edgesBinding = 7;

#endif

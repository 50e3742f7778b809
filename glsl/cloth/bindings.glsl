// Bindings of the arrays of the cloth kernels.
#ifndef CLOTH_BINDINGS
#define CLOTH_BINDINGS

const int positionsBinding = 0;
const int nextPositionsBinding = 1;
const int velocitiesBinding = 2;
const int shiftsBinding = 3;  // of the kernels of thin colliders
const int aimsBinding = 3;    // of the kernels that predict: velocities before constraints
const int trendsBinding = 5;
const int leftBinding = 5;    // of the kernel that settles again
const int waysBinding = 5;    // of the kernel that holds pins

#endif

// Where the particle kernels' arrays are bound.
#ifndef PARTICLE_BINDINGS
#define PARTICLE_BINDINGS

const int positionsBinding = 0;
const int velocitiesBinding = 1;
const int accelerationsBinding = 2;
const int startsBinding = 2;  // where a substep began, of kernels that read no accelerations

#endif

// Binding points of the arrays of the particle kernels.
#ifndef PARTICLE_BINDINGS
#define PARTICLE_BINDINGS

const int positionsBinding = 0;
const int velocitiesBinding = 1;
const int accelerationsBinding = 2;
const int spinsBinding = 5;   // Angular velocities of balls that turn
const int startsBinding = 2;  // Positions at the start of a substep, used by kernels that read no accelerations

#endif

// Binding points of the arrays of the contact kernels. solve.comp leaves the binding points of particles/kernel.glsl
// free.
#ifndef BALL_BINDINGS
#define BALL_BINDINGS

const int placesBinding = 0;   // Balls in sorted order; in key.comp and gather.comp, the particles in slot order
const int beginsBinding = 1;   // Positions at the substep's start and radii, in sorted order
const int listsBinding = 2;    // Lists of the neighbours of each ball
const int recordsBinding = 3;
const int tableBinding = 4;
const int nextBinding = 5;     // Positions of the balls after an iteration
const int speedsBinding = 6;   // Velocities before the corrections, in sorted order
const int ballVelocitiesBinding = 7;
const int guessesBinding = 9;  // Positions before the corrections and masses, in sorted order
const int ballStartsBinding = 10;  // Positions at the substep's start

#endif

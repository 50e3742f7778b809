// Binding points of the arrays of the contact kernels. solve.comp and strike.comp leave the binding points of
// particles/kernel.glsl free.
#ifndef BALL_BINDINGS
#define BALL_BINDINGS

const int placesBinding = 0;   // Balls in sorted order; in key.comp and gather.comp, the particles in slot order
const int beginsBinding = 1;   // Positions at the substep's start and radii, in sorted order
const int listsBinding = 2;    // Neighbours of each ball
const int choicesBinding = 2;  // Partner of each ball in its first impact; in choose.comp 3
const int choosesBinding = 3;  // The array of choicesBinding as an output
const int recordsBinding = 3;
const int tableBinding = 4;
const int nextBinding = 5;     // Balls after an iteration or an impact
const int speedsBinding = 6;   // Velocities before the corrections, in sorted order; in key.comp, in slot order
const int ballVelocitiesBinding = 7;
const int guessesBinding = 9;  // Positions before the corrections and masses, in sorted order
const int ballStartsBinding = 10;  // Positions at the substep's start
const int pathSpeedsBinding = 10;  // The array of speedsBinding in strike.comp
const int nextSpeedsBinding = 11;
const int struckBinding = 10;      // Positions after the impacts
const int turnsBinding = 4;        // Orientations of balls that turn, in slot order
const int rollsBinding = 12;       // Angular velocities of balls that turn, or angles of the substep, times their radii
const int nextRollsBinding = 13;   // The same after an iteration or an impact

#endif

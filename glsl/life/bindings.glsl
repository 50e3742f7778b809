#ifndef LIFE_BINDINGS
#define LIFE_BINDINGS

const int cellsBinding = 0;
const int nextCellsBinding = 1;
const int stampsBinding = 2;
const int trailsBinding = 3;
const int marksBinding = 4;

#endif

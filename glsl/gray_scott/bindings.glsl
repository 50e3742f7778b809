#ifndef GRAY_SCOTT_BINDINGS
#define GRAY_SCOTT_BINDINGS

const int cellsBinding = 0;
const int nextCellsBinding = 1;
const int weightsBinding = 2;
const int stampsBinding = 3;

#endif

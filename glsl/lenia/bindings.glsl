#ifndef LENIA_BINDINGS
#define LENIA_BINDINGS

const int cellsBinding = 0;
const int paddedBinding = 1;
const int weightsBinding = 2;
const int nextCellsBinding = 3;
const int stampsBinding = 4;

#endif

#ifndef WATER_BINDINGS
#define WATER_BINDINGS

const int cellsBinding = 0;
const int nextCellsBinding = 1;
const int stampsBinding = 2;
const int shownBinding = 3;

#endif

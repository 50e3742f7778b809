// Where the gravity tree's arrays are bound.
#ifndef TREE_BINDINGS
#define TREE_BINDINGS

const int positionsBinding = 0;
const int cornersBinding = 1;
const int recordsBinding = 2;
const int bodiesBinding = 3;
const int boxesBinding = 4;
const int cellsBinding = 5;
const int momentsBinding = 6;
const int accelerationsBinding = 7;

#endif

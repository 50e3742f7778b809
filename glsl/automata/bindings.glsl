#ifndef AUTOMATA_BINDINGS
#define AUTOMATA_BINDINGS

const int cellsBinding = 0;
const int nextCellsBinding = 1;
const int paddedBinding = 2;
const int sumsBinding = 3;
const int treeBinding = 4;
const int wordsBinding = 5;
const int bytesBinding = 6;
const int stampsBinding = 7;
const int rowSumsBinding = 0;

#endif

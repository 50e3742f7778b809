// Storage blocks of the kernels of this folder.
#ifndef CAVE_BINDINGS
#define CAVE_BINDINGS

const int cellsBinding = 0;      // words of cells.glsl
const int nextCellsBinding = 1;
const int labelsBinding = 1;     // of runs: the lowest cell of the region
const int tallyBinding = 2;      // of regions: cells; of rooms: the tree they belong to
const int flagsBinding = 3;
const int sourcesBinding = 4;    // of cells: the nearest open cell
const int nextSourcesBinding = 5;
const int weightsBinding = 5;    // of trees: the length of the shortest way to another
const int edgesBinding = 6;      // of trees: where that way crosses
const int linksBinding = 7;      // of trees: the one they join
const int dugBinding = 7;        // words of cells
const int distancesBinding = 4;  // of cells: steps from the start of the waves
const int queueBinding = 5;

#endif

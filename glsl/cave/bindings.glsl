// Binding points of the storage buffers of the cave kernels. Compiles as GLSL and as C++.
#ifndef CAVE_BINDINGS
#define CAVE_BINDINGS

const int cellsBinding = 0;      // Words of cells (see cells.glsl)
const int nextCellsBinding = 1;
const int labelsBinding = 1;     // Per run: lowest cell of its region
const int tallyBinding = 2;      // Per region: number of cells. Per room: the tree it belongs to
const int flagsBinding = 3;
const int sourcesBinding = 4;    // Per cell: nearest open cell
const int nextSourcesBinding = 5;
const int weightsBinding = 5;    // Per tree: length of the shortest connection to another tree
const int edgesBinding = 6;      // Per tree: the edge at which this connection crosses
const int linksBinding = 7;      // Per tree: the tree that it joins
const int dugBinding = 7;        // Words of cells with the dug corridors
const int distancesBinding = 4;  // Per cell: steps from the start of the waves
const int queueBinding = 5;

#endif

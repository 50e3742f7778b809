// Binding points of the storage buffers of the cave kernels. Compiles as GLSL and as C++.
#ifndef CAVE_BINDINGS
#define CAVE_BINDINGS

const int cellsBinding = 0;      // Words of cells (see cells.glsl)
const int nextCellsBinding = 1;
const int beforeBinding = 1;     // Words of cells of the stage before
const int blendedBinding = 2;    // For each cell: a float between 0, open, and 1, rock
const int labelsBinding = 1;     // For each run: lowest cell of its region
const int tallyBinding = 2;      // For each region: number of cells. For each room: the tree to which the room belongs
const int flagsBinding = 3;
const int sourcesBinding = 4;    // For each cell: nearest open cell
const int nextSourcesBinding = 5;
const int weightsBinding = 5;    // For each tree: length of the shortest connection to another tree
const int edgesBinding = 6;      // For each tree: index of the edge that this connection crosses
const int linksBinding = 7;      // For each tree: the tree to which it is joined
const int dugBinding = 7;        // Words of the cells into which corridors are dug
const int distancesBinding = 4;  // For each cell: number of steps from the start of the waves
const int queueBinding = 5;

#endif

// Where the arrays of cloth made of triangles are bound, beside heights (3) and walls (4) of the kernel that meets them.
#ifndef CLOTH_MESH_BINDINGS
#define CLOTH_MESH_BINDINGS

const int positionsBinding = 0;
const int nextPositionsBinding = 1;
const int velocitiesBinding = 2;
const int trendsBinding = 3;         // of the kernels that predict and attach
const int shiftsBinding = 3;         // of the kernels of thin colliders
const int faceForcesBinding = 4;
const int elementsBinding = 4;       // of the kernel that stretches
const int cornersBinding = 5;
const int settledTrendsBinding = 5;
const int leftBinding = 5;           // of the kernel that settles again
const int stitchesBinding = 5;
const int attachmentsBinding = 5;
const int entriesBinding = 5;        // of the kernels that gather by vertex
const int fansBinding = 6;
const int drawnPositionsBinding = 1; // of the kernel that makes what is drawn
const int drawnNormalsBinding = 2;
const int copiesBinding = 3;
const int ringsBinding = 7;          // of kernels that note no loss

#endif

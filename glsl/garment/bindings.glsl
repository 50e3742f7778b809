// Binding points of the arrays of the garment kernels (cloth made of triangles). Bindings 3 and 4 hold heights and
// walls in the kernel that tests contact. Some kernels reuse a binding point for other arrays.
#ifndef CLOTH_MESH_BINDINGS
#define CLOTH_MESH_BINDINGS

const int positionsBinding = 0;
const int nextPositionsBinding = 1;
const int velocitiesBinding = 2;
const int trendsBinding = 3;         // Used by predict.comp and attach.comp
const int shiftsBinding = 3;         // Used by the kernels of thin colliders
const int faceForcesBinding = 4;
const int elementsBinding = 4;       // Used by stretch.comp
const int cornersBinding = 5;
const int settledTrendsBinding = 5;
const int leftBinding = 5;           // Used by settle.comp if AGAIN is defined
const int stitchesBinding = 5;
const int attachmentsBinding = 5;
const int entriesBinding = 5;        // Used by the kernels that gather bending entries per vertex
const int fansBinding = 6;
const int drawnPositionsBinding = 1; // Used by show.comp
const int drawnNormalsBinding = 2;
const int copiesBinding = 3;
const int ringsBinding = 7;          // Used only by kernels that do not write the status block

#endif

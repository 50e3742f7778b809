// Binding points of the kernels that build distance fields. Compiles as GLSL and as C++ (src/sim/collide).
#ifndef COLLIDE_DISTANCE_BINDINGS
#define COLLIDE_DISTANCE_BINDINGS

const int boxesBinding = 0;
const int facesBinding = 1;
const int nodesBinding = 2;
const int cellsBinding = 3;
const int leftBinding = 4;  // Counter of unfinished nodes
const int leafFaces = 4;    // Number of faces per leaf of the tree; a face may occur twice
// Number of elements per face: three corners, then the unit normals of the face, of its edges and of its corners
const int faceElements = 10;

#endif

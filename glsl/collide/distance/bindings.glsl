// Where the kernels that make distance fields have their arrays. Compiles as GLSL and as C++ (src/sim/collide).
#ifndef COLLIDE_DISTANCE_BINDINGS
#define COLLIDE_DISTANCE_BINDINGS

const int boxesBinding = 0;
const int facesBinding = 1;
const int nodesBinding = 2;
const int cellsBinding = 3;
const int leftBinding = 4;  // of the count of nodes that are not done
const int leafFaces = 4;    // of a leaf of the tree, some of them twice
const int faceElements = 10;  // of a face: three corners; unit normals of the face, its edges, its corners

#endif

// Binding points of the mesh kernels, which also use heightsBinding of height_types.glsl.
#ifndef MESH_BINDINGS
#define MESH_BINDINGS

const int restPositionsBinding = 0;
const int trailBinding = 1;
const int positionsBinding = 2;
const int facesBinding = 4;
const int restNormalsBinding = 5;
const int normalsBinding = 6;
const int fansBinding = 7;

#endif

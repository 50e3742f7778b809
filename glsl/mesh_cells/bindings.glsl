// What gives the vertices of a mesh the colours of their cells. Compiles as GLSL and as C++.
#ifndef MESH_CELLS_BINDINGS
#define MESH_CELLS_BINDINGS

const int cellValuesUnit = 0;    // texture: words of the cells' values
const int restBinding = 1;       // where vertices are; w: the number of their cell, as bits
const int paintedBinding = 2;    // the same; w: the number of their colour
const int meshColors = 1024;     // of the palette, from the lowest value to the highest

#endif

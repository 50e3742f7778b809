// Binding points of the kernel that colours a mesh's vertices by their cells. Compiles as GLSL and as C++.
#ifndef MESH_CELLS_BINDINGS
#define MESH_CELLS_BINDINGS

const int cellValuesUnit = 0;    // Texture unit: words of the cells' values
const int restBinding = 1;       // Undeformed positions; w: index of the vertex's cell, as float bits
const int paintedBinding = 2;    // Output positions; w: colour index
const int meshColors = 1024;     // Number of colours in the palette, from the lowest value to the highest

#endif

// What the kernels of this folder bind.
#ifndef CONTOUR_BINDINGS
#define CONTOUR_BINDINGS

// Textures: the field's words.
const int fieldUnit = 0;
// Storage blocks, and textures where memory.glsl has it so.
const int classesBinding = 1;
const int talliesBinding = 2;
const int tileSumsBinding = 3;
const int squaresBinding = 2;    // of points: the square that each goes on in
const int listedBinding = 5;     // where they are written
const int drawBinding = 4;       // what is drawn: ContourDraw of types.glsl
const int positionsBinding = 5;
const int normalsBinding = 6;
const int indicesBinding = 7;
const int nextPointsBinding = 0;

#endif

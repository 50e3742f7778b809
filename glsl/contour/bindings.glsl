// Binding points of the contour kernels. Compiles as GLSL and as C++.
#ifndef CONTOUR_BINDINGS
#define CONTOUR_BINDINGS

// Texture unit of the words of the field.
const int fieldUnit = 0;
// Binding points of storage buffers, or of texel buffers where memory.glsl uses texel buffers.
const int classesBinding = 1;
const int talliesBinding = 2;
const int tileSumsBinding = 3;
const int squaresBinding = 2;    // For each point: the square in which its contour continues
const int listedBinding = 5;     // The array of squaresBinding as output
const int drawBinding = 4;       // Draw arguments: a ContourDraw of types.glsl
const int positionsBinding = 5;
const int normalsBinding = 6;
const int indicesBinding = 7;
const int nextPointsBinding = 0;

#endif

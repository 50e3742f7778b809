// Binding points of the volume kernels. Compiles as GLSL and as C++.
#ifndef VOLUME_BINDINGS
#define VOLUME_BINDINGS

// Texture units: words of the values that define the surface, and words of the values that colour it.
const int valuesUnit = 0;
const int tintsUnit = 1;
// Binding points of storage buffers, or of texel buffers where memory.glsl uses texel buffers.
const int cubesBinding = 2;      // Triangles of each kind of cube
const int classesBinding = 3;    // x: one bit for each of 32 samples along a row, set if the sample is at or above the
                                 // level
const int talliesBinding = 4;
const int masksBinding = 5;      // For each 32 samples: bit masks of crossed edges along x, y and z, and of cubes with
                                 // triangles
const int positionsBinding = 6;
const int normalsBinding = 7;
const int indicesBinding = 6;
const int boxIndicesBinding = 2;  // Used for the display as cubes, which needs no triangle table

// Number of vertices before the points: the corners of the volume's box, which give bounds of the surface.
const int boxCorners = 8;
// Number of colours in the palette, from the lowest value to the highest.
const int volumeColors = 1024;

#endif

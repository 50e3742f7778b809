// What the kernels of this folder bind. Compiles as GLSL and as C++.
#ifndef VOLUME_BINDINGS
#define VOLUME_BINDINGS

// Textures: words of the values whose surface it is, and of those that colour it.
const int valuesUnit = 0;
const int tintsUnit = 1;
// Storage blocks, and textures where memory.glsl has it so.
const int cubesBinding = 2;      // triangles of each kind of cube
const int classesBinding = 3;    // x: of 32 samples, a bit each
const int talliesBinding = 4;
const int masksBinding = 5;      // of 32 samples: crossed edges along x, y and z; cubes with triangles
const int positionsBinding = 6;
const int normalsBinding = 7;
const int indicesBinding = 6;
const int boxIndicesBinding = 2;  // of cubes, which need no table

// Vertices before the points: the corners of the volume's box, for whoever asks how far the surface may reach.
const int boxCorners = 8;
// Colours of a palette, from the lowest value to the highest.
const int volumeColors = 1024;

#endif

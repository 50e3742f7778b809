// How relax.comp cuts the sheet. Compiles as GLSL and as C++. 24,576 bytes of shared memory: a processor that gives 64 KB to its
// groups (Hopper under OpenGL) has two of them at a time, of 32,768 bytes only one, and then waits at its barriers.
#ifndef CLOTH_RELAX_TILE
#define CLOTH_RELAX_TILE
const int relaxGroupX = 24;
const int relaxGroupY = 32;
const int relaxTileX = 48;
const int relaxTileY = 32;
// What becomes of a particle depends on others up to so far away: on the other end of its own pair of a family's second
// colour, which that one's pair of the first colour has moved. Two diagonal families reach 2 each, each bending one 4 along its axis.
const int relaxHalo = 4;
// Multiples of four, so that all tiles have the same colours.
const int relaxInnerX = relaxTileX - 2 * relaxHalo;
const int relaxInnerY = relaxTileY - 2 * relaxHalo;
#endif

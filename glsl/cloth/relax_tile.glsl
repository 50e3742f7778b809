// How relax.comp cuts the sheet. Compiles as GLSL and as C++. 32,768 bytes of shared memory, which every device has.
#ifndef CLOTH_RELAX_TILE
#define CLOTH_RELAX_TILE
const int relaxGroupX = 32;
const int relaxGroupY = 32;
const int relaxTileX = 64;
const int relaxTileY = 32;
// What becomes of a particle depends on others up to so far away: on the other end of its own pair of a family's second
// colour, which that one's pair of the first colour has moved. Two diagonal families reach 2 each, each bending one 4 along its axis.
const int relaxHalo = 4;
const int relaxInnerX = relaxTileX - 2 * relaxHalo;
const int relaxInnerY = relaxTileY - 2 * relaxHalo;
#endif

// Tile size of relax.comp. Compiles as GLSL and as C++. The tile takes 24,576 bytes of shared memory, so that a
// multiprocessor with 48 KB for workgroups (NVIDIA Hopper under OpenGL) runs two workgroups at a time. With larger
// tiles it would run only one and be idle at barriers.
#ifndef CLOTH_RELAX_TILE
#define CLOTH_RELAX_TILE
const int relaxTileX = 48;
const int relaxTileY = 32;
// Halo widths: the maximum distance, in particles, at which other particles affect a particle. In one family, a
// particle moves with its partner of the first colour on one side and with its partner of the second colour on the
// other side. The partner of the second colour has already moved with its own partner of the first colour. A family
// therefore needs a halo of at most two reaches, and of only one reach on the side of the particle's first partner.
// Tiles start at even positions, and their output starts at odd positions. For these positions, the two diagonal
// families need 2 and 1 particles, together 3 on each side. The bending families act along one axis each. Their tiles
// start at multiples of four and their output starts two positions later; the halo is 2, which is one reach.
const int relaxDiagonalHalo = 3;
const int relaxBendHalo = 2;
// Number of particles by which the first tile starts outside the sheet.
const int relaxBefore = 4;
#endif

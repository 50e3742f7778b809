// Tile size of relax.comp. Compiles as GLSL and as C++. The tile takes 24,576 bytes of shared memory: a multiprocessor
// with 48 KB for workgroups (NVIDIA Hopper under OpenGL) then runs two workgroups at once. With larger tiles it would
// run one, and idle at the barriers.
#ifndef CLOTH_RELAX_TILE
#define CLOTH_RELAX_TILE
const int relaxTileX = 48;
const int relaxTileY = 32;
// Halo widths: the greatest distance over which other particles affect a particle. In one family a particle moves with
// its partner of the first colour on one side, and with its partner of the second colour on the other side. The second
// partner has already moved with its own first partner. So a family needs at most two reaches, and only one on the side
// of the particle's own first partner. Tiles begin at even positions, and their output begins one position after a
// multiple of two. There the two diagonal families need 2 and 1 positions, 3 on each side in total. The bending
// families act along one axis each. Their tiles begin at multiples of four and their output begins two positions later:
// the halo is 2, one reach.
const int relaxDiagonalHalo = 3;
const int relaxBendHalo = 2;
// Distance by which the first tile begins outside the sheet, in particles.
const int relaxBefore = 4;
#endif

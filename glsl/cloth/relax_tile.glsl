// How relax.comp cuts the sheet. Compiles as GLSL and as C++. 24,576 bytes of shared memory: a processor that gives 48 KB to its
// groups (Hopper under OpenGL) has two of them at a time, of more only one, and then waits at its barriers.
#ifndef CLOTH_RELAX_TILE
#define CLOTH_RELAX_TILE
const int relaxTileX = 48;
const int relaxTileY = 32;
// What becomes of a particle depends on others up to so far away from it. In a family it is moved with its partner of the first
// colour, one reach away on one side, and with that of the second, on the other side, which its own partner of the first colour
// has moved: at most two reaches, but only one on the side where its own first partner is. Tiles begin at even places, and
// what they leave one after a multiple of two: there diagonal families reach 2 and 1, together 3 on every side. Those of bending,
// each along one axis, begin at multiples of four and leave what begins at two after one: 2, one reach.
const int relaxDiagonalHalo = 3;
const int relaxBendHalo = 2;
// So far before the sheet the first tile begins.
const int relaxBefore = 4;
#endif

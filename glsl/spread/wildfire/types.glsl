// What the wildfire's kernels read once per step. Compiles as GLSL and as C++ (src/sim/spread/wildfire_plan.hpp). Only
// 16-byte members, so std140 and std430 agree.
#ifndef WILDFIRE_TYPES
#define WILDFIRE_TYPES

const uint evenGround = 0x8080u;  // an incline of none
const int mostRise = 127;         // of an incline, in sixteenths of a cell a cell: 82.8 degrees

struct WildfireStep {
  uvec4 spread[2];  // chance, in 1/65536, that a burning neighbour lights full and dry fuel: above left, above, above
                    // right, left, right, below left, below, below right
  uvec4 numbers;    // step, seed, steps that a cell burns, which burnt cells cool: the first of the phases 0 to 15 and
                    // 256 times how many of them
  ivec4 embers;     // how far the longest flight goes (x and y, 1/256 cell), how far to its side (1/256 of it),
                    // threshold of landing
};

#endif

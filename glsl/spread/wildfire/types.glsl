// What the wildfire's kernels read once per step. Compiles as GLSL and as C++ (src/sim/spread/wildfire_plan.hpp).
#ifndef WILDFIRE_TYPES
#define WILDFIRE_TYPES

const uint evenGround = 0x8080u;  // an incline of none
const int maxRise = 127;         // of an incline, in sixteenths of a cell a cell: 82.8 degrees

// What a scene says and the kernels read as it is.
struct STD140 WildfireConstants {
  int burnSteps DEFAULT(24);  // that a cell burns
};

struct STD140 WildfireStep {
  uvec4 spread[2];  // chance, in 1/65536, that a burning neighbour lights full and dry fuel: above left, above, above
                    // right, left, right, below left, below, below right
  ivec2 emberFlight;     // the longest, 1/256 cell
  uint step;
  uint seed;
  uint firstPhase;       // burnt cells of these phases cool now: the first, 0 to 15,
  uint phases;           // and how many
  uint emberThreshold;   // of landing
  int emberSpread;       // how far it goes to its side, 1/256 of the flight
  float emberReach;      // where a fluid blows: 1/256 cell of the longest flight for a gale of 1/2048
  WildfireConstants constants;
};

#endif

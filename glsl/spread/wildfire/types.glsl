// Uniform block that the wildfire's kernels read once per step. Compiles as GLSL and as C++
// (src/sim/spread/wildfire_plan.hpp).
#ifndef WILDFIRE_TYPES
#define WILDFIRE_TYPES

const uint evenGround = 0x8080u;  // Incline of level ground
const int maxRise = 127;         // Maximum rise of an incline, in units of 1/16 cell per cell; corresponds to 82.8
                                 // degrees

// Scene parameters that the kernels use unchanged.
struct STD140 WildfireConstants {
  int burnSteps DEFAULT(24);  // Number of steps for which a cell burns
};

struct STD140 WildfireStep {
  uvec4 spread[2];  // Chances, in units of 1/65536, that a burning neighbour ignites full, dry fuel, in this order:
                    // above left, above, above right, left, right, below left, below, below right
  ivec2 emberFlight;     // Maximum flight, in units of 1/256 cell
  uint step;
  uint seed;
  uint firstPhase;       // First phase of burnt cells that cool in this step, 0 to 15
  uint phases;           // Number of phases that cool in this step
  uint emberThreshold;   // Threshold for the landing of an ember
  int emberSpread;       // Sideways deviation of an ember, in units of 1/256 of its flight
  float emberReach;      // If a fluid is the wind: maximum flight in units of 1/256 cell, per unit of a gale (1/2048)
  WildfireConstants constants;
};

#endif

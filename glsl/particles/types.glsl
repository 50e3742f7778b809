// What the particle kernels read once per substep. Compiles as GLSL and as C++
// (src/sim/particles_plan.hpp). Only 16-byte members, so std140 and std430 agree.
#ifndef PARTICLE_TYPES
#define PARTICLE_TYPES

const int mostEmitters = 16;
// All-pairs gravity adds this many bodies into a sum of their own before they join the total. The size
// decides how sums round, so both memory paths and the CPU twin share it.
const int chunkBodies = 1024;

// A ring of slots; newborns fill it in turn.
struct EmitterStep {
  vec4 position;  // xyz m; w radius (m) of the ball in which particles appear
  vec4 forward;   // xyz unit vector of the mean velocity; w speed (m/s)
  vec4 side;      // xyz unit vector across; w variation of the speed (share)
  vec4 up;        // xyz forward x side; w 1 - cos(spread)
  vec4 life;      // x lifetime (s), y its variation (share), z mass (kg), w spare
  ivec4 slots;    // x first slot, y number of slots, z place in the ring of the first newborn, w newborns
  ivec4 births;   // x serial number of the first newborn, the rest spare
};

struct ParticleStep {
  vec4 acceleration;  // xyz m/s^2 everywhere; w dt (s)
  vec4 attractor;     // xyz m; w G M (m^3/s^2)
  vec4 turbulence;    // xyz how far the field has drifted (m); w strength (m/s^2)
  vec4 factors;       // x dt of a half kick (s), y share of velocity kept, z attractor's eps^2 (m^2), w 1/size (1/m)
  ivec4 counts;       // particles, substep index since the start, seed, emitters
  EmitterStep emitters[mostEmitters];
};

#endif

// What the particle kernels read once per substep. Compiles as GLSL and as C++
// (src/sim/particles/plan.hpp). Only 16-byte members, so std140 and std430 agree.
#ifndef PARTICLE_TYPES
#define PARTICLE_TYPES

const int mostEmitters = 16;
// All-pairs gravity adds this many bodies into a sum of their own before they join the total. The size
// decides how sums round, so both memory paths and the CPU twin share it.
const int chunkBodies = 1024;

// A ring of slots; newborns fill it in turn, each at its own moment of the substep.
struct EmitterStep {
  vec4 position;        // xyz m, at the substep's end; w radius (m) of the ball in which particles appear
  vec4 positionBefore;  // the same at its start; w seconds between two births
  vec4 velocity;        // xyz m/s, the mean at the end; w variation of the speed (share)
  vec4 velocityBefore;  // the same at the start; w 1 - cos(spread)
  vec4 life;            // x lifetime (s), y its variation (share), z mass (kg), w seconds the first newborn has lived at
                        // the substep's end
  ivec4 slots;          // x first slot, y number of slots, z place in the ring of the first newborn, w newborns
  ivec4 births;         // x serial number of the first newborn, the rest spare
};

// What accelerates particles wherever they are, at one moment.
struct ParticleFields {
  vec4 acceleration;  // xyz m/s^2 everywhere; w spare
  vec4 attractor;     // xyz m; w G M (m^3/s^2)
  vec4 turbulence;    // xyz how far the field has drifted (m); w strength (m/s^2)
};

struct ParticleStep {
  ParticleFields fields;        // at the substep's end
  ParticleFields fieldsBefore;  // at its start
  vec4 pace;                    // of a whole substep: see paceOf() of pace.glsl
  vec4 factors;                 // x dt (s), y damping rate (1/s), z attractor's eps^2 (m^2), w 1/size (1/m)
  ivec4 counts;                 // particles, substep index since the start, seed, emitters
  EmitterStep emitters[mostEmitters];
};

#endif

// What the particle kernels read once per substep. Compiles as GLSL and as C++ (src/sim/particles). A struct's
// vec4 come first, so that std140 and C++ agree.
#ifndef PARTICLE_TYPES
#define PARTICLE_TYPES

#include "collide/types.glsl"

const int maxEmitters = 16;
// All-pairs gravity adds this many bodies into a sum of their own before they join the total. The size
// decides how sums round, so both memory paths and the CPU twin share it.
const int chunkBodies = 1024;

// What a scene says and the kernels read as it is.
struct STD140 EmitterConstants {
  float radius DEFAULT(0.0f);             // m, of the ball in which particles appear
  float speedVariation DEFAULT(0.3f);     // fraction
  float lifetime DEFAULT(2.0f);           // s
  float lifetimeVariation DEFAULT(0.3f);  // fraction
  float mass DEFAULT(1.0f);               // kg
};

struct STD140 TurbulenceConstants {
  float strength DEFAULT(0.0f);  // m/s^2
};

struct STD140 ParticleConstants {
  float damping DEFAULT(0.0f);             // 1/s, towards rest; 0.06 keeps 0.999 at 60 Hz
  float attractorSoftening DEFAULT(0.1f);  // m
  float bounce DEFAULT(0.3f);              // fraction of the speed of impact that is given back
  float margin DEFAULT(0.0f);              // m kept from what they touch
};

// A ring of slots; newborns fill it in turn, each at its own moment of the substep.
struct STD140 EmitterStep {
  vec4 position;          // xyz m, at the substep's end
  vec4 positionBefore;    // the same at its start
  vec4 velocity;          // xyz m/s, the mean at the end
  vec4 velocityBefore;    // the same at the start
  float coneHeight;       // 1 - cos(spread)
  float birthInterval;    // s between two births
  float firstLived;       // s the first newborn has lived at the substep's end
  int firstSlot;
  int slots;
  int firstPlace;         // in the ring, of the first newborn
  int newborns;
  int firstSerial;        // number of the first newborn since the start
  EmitterConstants constants;
};

// What accelerates particles wherever they are, at one moment.
struct STD140 ParticleFields {
  vec4 acceleration;     // xyz m/s^2 everywhere
  vec4 attractor;        // xyz m; w G M (m^3/s^2)
  vec4 turbulenceDrift;  // xyz how far the field has drifted (m)
};

// How far one step of a damped leapfrog goes: see paceOf() of pace.glsl.
struct STD140 Pace {
  float firstKick;   // s
  float drift;       // s
  float kept;        // fraction of velocity
  float secondKick;  // s
};

struct STD140 ParticleStep {
  ParticleFields fields;        // at the substep's end
  ParticleFields fieldsBefore;  // at its start
  Pace pace;                    // of a whole substep
  float dt;                     // s
  float perTurbulenceSize;      // 1/m
  int count;
  int substep;                  // since the start
  int seed;
  int emitterCount;
  int colliderCount;
  float windDrag;               // 1/s, at which velocity becomes the wind's; the constants' damping has it, too
  ParticleConstants constants;
  TurbulenceConstants turbulence;
  EmitterStep emitters[maxEmitters];
  Collider colliders[maxColliders];
};

#endif

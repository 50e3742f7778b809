// Uniform block that the particle kernels read once per substep. Compiles as GLSL and as C++ (src/sim/particles). The
// vec4 members of a struct come first, so that std140 and C++ have the same layout.
#ifndef PARTICLE_TYPES
#define PARTICLE_TYPES

#include "collide/types.glsl"

const int maxEmitters = 16;
// Number of bodies per partial sum of all-pairs gravity. It affects rounding, so both memory paths and the CPU twin use
// the same number.
const int chunkBodies = 1024;

// Scene parameters that the kernels use unchanged.
struct STD140 EmitterConstants {
  float radius DEFAULT(0.0f);             // Radius of the ball in which particles appear, m
  float speedVariation DEFAULT(0.3f);     // Random variation of the speed, as a fraction of the mean
  float lifetime DEFAULT(2.0f);           // Mean lifetime in seconds
  float lifetimeVariation DEFAULT(0.3f);  // Random variation of the lifetime, as a fraction of the mean
  float mass DEFAULT(1.0f);               // Mass of a particle in kg
};

struct STD140 TurbulenceConstants {
  float strength DEFAULT(0.0f);  // Strength of the acceleration in m/s^2
};

struct STD140 ParticleConstants {
  float damping DEFAULT(0.0f);             // Damping rate of the velocity, 1/s; with 0.06, a fraction of 0.999 remains
                                           // per step at 60 Hz
  float attractorSoftening DEFAULT(0.1f);  // Softening length of the attractor in metres
  float bounce DEFAULT(0.3f);              // Fraction of the impact speed that remains after the bounce
  float margin DEFAULT(0.0f);              // Distance kept from colliders, m
};

// Maximum number of particles of one bucket among which pairs are searched. With this limit, the loops over 27 buckets
// stay below the iteration limit of software drivers.
const int ballRun = 2048;

const int ballIterations = 4;   // over all contacts, per substep
const int mostBallImpacts = 8;  // of one ball in a substep

// Contact of particles as balls.
struct STD140 BallConstants {
  float radius DEFAULT(0.0f);       // Radius of a ball of the reference mass, m
  float friction DEFAULT(0.0f);     // Coulomb friction coefficient between balls
  float restitution DEFAULT(0.0f);  // Fraction of the approach speed that remains after a bounce
  float sizeExponent DEFAULT(0.0f);
  float perMassReference DEFAULT(1.0f);  // 1 / reference mass, 1/kg
  float perCell DEFAULT(1.0f);           // 1 / side of a cell, 1/m
  float bounceFrom DEFAULT(0.0f);        // Minimum approach speed at which balls bounce, m/s
  float restSpeed DEFAULT(0.0f);         // Speed that the uniform acceleration adds in a substep, m/s
  float perDt DEFAULT(0.0f);             // 1 / duration of a substep, 1/s
  int tableMask DEFAULT(1);              // Number of buckets in the table, minus 1; serves as a bit mask
  int listed DEFAULT(16);                // Maximum number of neighbours of a ball, a multiple of 4
  int rolls DEFAULT(0);                  // 1 if balls have an angular velocity
};

// Emitter: a ring buffer of slots. New particles take the slots in turn; each has its own moment of birth within the
// substep.
struct STD140 EmitterStep {
  vec4 position;          // xyz position at the end of the substep, m
  vec4 positionBefore;    // xyz position at the start of the substep, m
  vec4 velocity;          // xyz mean velocity of new particles at the end of the substep, m/s
  vec4 velocityBefore;    // xyz mean velocity of new particles at the start of the substep, m/s
  float coneHeight;       // 1 - cos(spread angle)
  float birthInterval;    // Seconds between two births
  float firstLived;       // Time in seconds that the first new particle has lived at the end of the substep
  int firstSlot;
  int slots;
  int firstPlace;         // Index in the ring of the first new particle
  int newborns;
  int firstSerial;        // Serial number of the first new particle, counted from the start
  EmitterConstants constants;
};

// Fields that accelerate all particles, at a given time.
struct STD140 ParticleFields {
  vec4 acceleration;     // xyz uniform acceleration, m/s^2
  vec4 attractor;        // xyz position, m; w gravitational constant times mass, m^3/s^2
  vec4 turbulenceDrift;  // xyz displacement of the noise field, m
};

// Coefficients of a damped leapfrog step (see paceOf() in pace.glsl).
struct STD140 Pace {
  float firstKick;   // Duration of the first kick in seconds
  float drift;       // Duration of the drift in seconds
  float kept;        // Fraction of the velocity that remains after damping
  float secondKick;  // Duration of the second kick in seconds
};

struct STD140 ParticleStep {
  ParticleFields fields;        // Fields at the end of the substep
  ParticleFields fieldsBefore;  // Fields at the start of the substep
  Pace pace;                    // Coefficients for a whole substep
  float dt;                     // Duration of a substep in seconds
  float perTurbulenceSize;      // 1 / size of the swirls, in 1/m
  int count;
  int substep;                  // Number of substeps since the start
  int seed;
  int emitterCount;
  int colliderCount;
  float windDrag;               // Rate at which the velocity approaches the velocity of the wind, 1/s;
                                // constants.damping includes this rate
  ParticleConstants constants;
  TurbulenceConstants turbulence;
  BallConstants balls;
  EmitterStep emitters[maxEmitters];
  Collider colliders[maxColliders];
};

#endif

// What cloth and particles are told of the shapes that they touch, each substep. Compiles as GLSL and as C++
// (src/sim/collide).
#ifndef COLLIDE_TYPES
#define COLLIDE_TYPES

const int maxColliders = 32;

// A sphere or capsule around the segment a-b, or the plane n.x = d.
struct STD140 Collider {
  vec4 a;                 // xyz start of the segment (m), or n
  vec4 b;                 // xyz end of the segment
  vec4 velocityA;         // xyz m/s of the start
  vec4 velocityB;         // xyz m/s of the end
  float reach;            // radius or d, m
  float perLengthSquared; // 1/|b-a|^2, 0 for a sphere
  float grip;             // fraction of tangential velocity kept per substep
  int plane;              // 1: it is one
  float friction;         // Coulomb's coefficient; below 0: grip
};

#endif

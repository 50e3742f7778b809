// Shapes with which cloth and particles collide, updated in each substep. Compiles as GLSL and as C++
// (src/sim/collide).
#ifndef COLLIDE_TYPES
#define COLLIDE_TYPES

const int maxColliders = 32;

// Sphere or capsule around the segment a-b, or the plane n.x = d.
struct STD140 Collider {
  vec4 a;                 // xyz start of the segment, m; or normal n of the plane
  vec4 b;                 // xyz end of the segment, m
  vec4 velocityA;         // xyz velocity of the start, m/s
  vec4 velocityB;         // xyz velocity of the end, m/s
  float reach;            // Radius of the sphere or capsule, or d of the plane, m
  float perLengthSquared; // 1/|b-a|^2, or 0 for a sphere
  float grip;             // Fraction of the tangential velocity that remains after a substep
  int plane;              // 1 if the collider is a plane
  float friction;         // Coulomb friction coefficient; if negative, `grip` applies instead
};

#endif

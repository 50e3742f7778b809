// What the cloth kernels read once per substep. Compiles as GLSL and as C++ (src/sim/cloth/cloth.cpp). Only
// 16-byte members, so std140 and std430 agree.
#ifndef CLOTH_TYPES
#define CLOTH_TYPES

const int mostColliders = 12;
const int mostPinFrames = 8;

// A sphere or capsule around the segment a-b, or the plane n.x = d.
struct Collider {
  vec4 a;          // xyz start of the segment (m) or unit normal; w radius (m) or d (m)
  vec4 b;          // xyz end of the segment; w 0: capsule, 1: plane
  vec4 velocityA;  // xyz m/s of the start; w share of tangential velocity kept per substep
  vec4 velocityB;  // xyz m/s of the end; w 1/|b-a|^2, 0 for a sphere
};

// Affine map of a pinned particle's rest position: row i gives component i.
struct PinFrame {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

struct ClothStep {
  vec4 gravity;        // xyz m/s^2; w dt (s)
  vec4 windForce;      // xyz N on each particle; w share of velocity kept per substep
  vec4 air;            // xyz air velocity (m/s); w density (kg/m^3)
  vec4 airShape;       // x drag coefficient, y lift coefficient, z gust strength (share of |air|), w 1/gust size (1/m)
  vec4 airDrift;       // xyz how far the gusts have travelled (m); w gust speed scale (m/s)
  vec4 origin;         // rest position of particle (0, 0); w margin kept from colliders (m)
  vec4 alongX;         // rest vector from a particle to its right neighbour; w rest length (m)
  vec4 alongY;         // rest vector to the next row; w 1/dt^2
  vec4 stiffness;      // structural, shear, bend (N/m); w 1/dt
  vec4 compliance;     // structural, shear, bend (m/N); w spare
  ivec4 counts;        // colliders, substep index since the start, seed, spare
  Collider colliders[mostColliders];
  PinFrame frames[mostPinFrames];
};

#endif

// What the cloth kernels read once per substep. Compiles as GLSL and as C++ (src/sim/cloth). A struct's vec4 come
// first, so that std140 and C++ agree.
#ifndef CLOTH_TYPES
#define CLOTH_TYPES

#include "collide/types.glsl"

const int maxPinFrames = 8;

// What a scene says and the kernels read as it is.
struct STD140 ClothConstants {
  float spacing DEFAULT(0.1f);           // m between neighbours at rest
  float stiffness DEFAULT(500.0f);       // N/m
  float shear DEFAULT(1.0f);             // ratio to stiffness
  float bend DEFAULT(0.3f);              // ratio to stiffness
  float compliance DEFAULT(0.0f);        // m/N
  float shearCompliance DEFAULT(0.0f);   // m/N
  float bendCompliance DEFAULT(0.01f);   // m/N
  float margin DEFAULT(0.01f);           // m kept from colliders
};

// A woven sheet by what it is per length and area, whatever the spacing.
struct STD140 FabricConstants {
  float density DEFAULT(0.115f);    // kg/m^2
  float weft DEFAULT(10000.0f);     // N/m, stretch along rows
  float warp DEFAULT(15000.0f);     // N/m, along columns
  float shear DEFAULT(50.0f);       // N/m, force along a side of unit length for an angle of 1
  float bending DEFAULT(6e-6f);     // N m, moment on a side of unit length for a curvature of 1/m
  float thickness DEFAULT(2.5e-4f); // m
};

struct STD140 AirConstants {
  float density DEFAULT(1.2f);  // kg/m^3
  float drag DEFAULT(1.0f);     // coefficient
  float lift DEFAULT(0.6f);     // coefficient
};

// Affine map of a pinned particle's rest position: row i gives component i.
struct STD140 PinFrame {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

struct STD140 ClothStep {
  vec4 gravity;        // xyz m/s^2
  vec4 wind;           // xyz N on each particle
  vec4 airVelocity;    // xyz m/s
  vec4 gustDrift;      // xyz how far the gusts have travelled (m)
  vec4 origin;         // xyz rest position of particle (0, 0) (m)
  vec4 alongX;         // xyz from a particle to its right neighbour at rest (m)
  vec4 alongY;         // xyz to the next row
  vec4 clamped[4];     // of the borders left, right, top, bottom: xyz from one to its neighbour within (m); w 1: it is held so
  float dt;            // s
  float perDt;         // 1/s
  float perReach;      // 1/s, 1 / h of constraints, h = 2/3 dt (cloth/motion.glsl)
  float trendDt;       // s, dt / 18
  float complianceScale; // 1/s^2, compliances' factor: 1 / h^2, with damping (1 - dampedPart) / h^2
  float kept;          // fraction of velocity kept per substep
  float gustSpeed;     // m/s, size of the gusts' variation
  float perGustSize;   // 1/m
  int colliderCount;
  int thinCount;       // of those after them, which edges and faces feel instead of vertices
  float thinRoom;      // m around a vertex within which its faces lie
  int substep;         // since the start
  int seed;
  float perBend;       // N/m, bending / spacing^2 of a fabric
  float dampedPart;    // T / (T + dt), of a fabric's stretchDamping T: how much of a stretch damping keeps over a substep
  float softening;     // of lines that keep energy, ratio to what a substep needs (cloth/keeping.glsl); 1 of others
  ClothConstants constants;
  FabricConstants fabric;
  AirConstants air;
  Collider colliders[maxColliders];
  PinFrame frames[maxPinFrames];
};

#endif

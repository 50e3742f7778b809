// Uniform block that the cloth kernels read once per substep. Compiles as GLSL and as C++ (src/sim/cloth). The vec4
// members of a struct come first, so that std140 and C++ have the same layout.
#ifndef CLOTH_TYPES
#define CLOTH_TYPES

#include "collide/types.glsl"

const int maxPinFrames = 8;

// Scene parameters that the kernels use unchanged.
struct STD140 ClothConstants {
  float spacing DEFAULT(0.1f);           // Rest distance between neighbours, in metres
  float stiffness DEFAULT(500.0f);       // Spring constant in N/m
  float shear DEFAULT(1.0f);             // Shear and bending stiffness as a ratio to `stiffness`
  float bend DEFAULT(0.3f);              // Shear and bending stiffness as a ratio to `stiffness`
  float compliance DEFAULT(0.0f);        // Compliance of structural links in m/N
  float shearCompliance DEFAULT(0.0f);   // Compliance of shear links in m/N
  float bendCompliance DEFAULT(0.01f);   // Compliance of bending links in m/N
  float margin DEFAULT(0.01f);           // Distance kept from colliders, in metres
};

// Woven fabric, described by properties per length and area that do not depend on the grid spacing.
struct STD140 FabricConstants {
  float density DEFAULT(0.115f);    // Mass per area in kg/m^2
  float weft DEFAULT(10000.0f);     // Stretch stiffness along rows, N/m
  float warp DEFAULT(15000.0f);     // Stretch stiffness along columns, N/m
  // Shear stiffness, N/m: force along a side of unit length for a shear angle of 1 rad
  float shear DEFAULT(50.0f);
  float bending DEFAULT(6e-6f);     // Bending stiffness, N m: moment on a side of unit length for a curvature of 1/m
  float thickness DEFAULT(2.5e-4f); // Thickness in metres
};

struct STD140 AirConstants {
  float density DEFAULT(1.2f);  // Air density, kg/m^3
  float drag DEFAULT(1.0f);     // Drag coefficient
  float lift DEFAULT(0.6f);     // Lift coefficient
};

// Affine map applied to the rest positions of pinned particles. Row i gives component i.
struct STD140 PinFrame {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

struct STD140 ClothStep {
  vec4 gravity;        // xyz: acceleration, m/s^2
  vec4 wind;           // xyz: force on each particle, N
  vec4 airVelocity;    // xyz: velocity of the air, m/s
  vec4 gustDrift;      // xyz: distance that the gusts have travelled, m
  vec4 origin;         // xyz: rest position of particle (0, 0), m
  vec4 alongX;         // xyz: rest offset to the next particle of a row, m
  vec4 alongY;         // xyz: rest offset to the next row, m
  // For each border (left, right, top, bottom): xyz rest offset to the inner neighbour (m); w is 1 if the border is
  // clamped
  vec4 clamped[4];
  float dt;            // Duration of a substep, s
  float perDt;         // 1 / dt, in 1/s
  float perReach;      // 1 / h in 1/s, where h = 2/3 dt is the time step of constraints (cloth/motion.glsl)
  float trendDt;       // dt / 18 in s, the factor of the trend (cloth/motion.glsl)
  float complianceScale; // Factor on compliances in 1/s^2: r (1 - dampedPart) / h^2; r is 2 for meshes relaxed twice, else 1
  float kept;          // Fraction of the velocity that remains after damping, per substep
  float gustSpeed;     // Amplitude of the gusts, m/s
  float perGustSize;   // 1 / gust size, 1/m
  int colliderCount;
  // Number of thin colliders; they follow the first colliderCount colliders and are tested against edges and faces, not
  // vertices
  int thinCount;
  float thinRoom;      // Distance from a vertex within which its faces lie, m
  int substep;         // Number of substeps since the start
  int seed;
  float perBend;       // bending / spacing^2 of a fabric in N/m
  // T / (T + dt), the fraction of stretch that damping preserves per substep; T is the fabric's stretchDamping
  float dampedPart;
  // Softening of lines that conserve energy, as a ratio to the substep's minimum (cloth/keeping.glsl); otherwise 1
  float softening;
  ClothConstants constants;
  FabricConstants fabric;
  AirConstants air;
  Collider colliders[maxColliders];
  PinFrame frames[maxPinFrames];
};

#endif

// Rigid meshes as what touches them sees them: signed distances at the corners of cells. Compiles as GLSL and as C++
// (src/sim/collide).
#ifndef COLLIDE_FIELD_TYPES
#define COLLIDE_FIELD_TYPES

const int maxMeshColliders = 8;
const int meshCollidersBinding = 1;  // of uniform blocks
const int fieldCellsBinding = 6;     // of the kernels that read them, beside what they have

struct STD140 MeshCollider {
  vec4 into[3];    // rows of the map from the world to the mesh's own space
  vec4 rate[3];    // rows of what maps a place there to the speed of the surface in the world (m/s)
  vec4 corner;     // xyz of the first cell's corner (m); w 1/side of a cell (1/m)
  ivec4 cells;     // along x, y, z; w its first one of all meshes' cells
  float cell;      // side, m
  float unit;      // m, of the whole numbers in which distances are kept
  float grip;      // fraction of tangential velocity kept per substep
  float friction;  // Coulomb's coefficient; below 0: grip
};

struct STD140 MeshColliders {
  MeshCollider meshes[maxMeshColliders];
  int count;
};

#endif

// Rigid meshes for collisions: signed distances at the corners of grid cells. Compiles as GLSL and as C++
// (src/sim/collide).
#ifndef COLLIDE_FIELD_TYPES
#define COLLIDE_FIELD_TYPES

const int maxMeshColliders = 8;
const int meshCollidersBinding = 1;  // Binding point of a uniform block
const int fieldCellsBinding = 6;     // Binding point of the distance fields in the kernels that read them

struct STD140 MeshCollider {
  vec4 into[3];    // Rows of the map from world space to object space
  vec4 rate[3];    // Rows of the map from a position in object space to the world velocity of the surface, m/s
  vec4 corner;     // xyz corner of the first cell, m; w 1 / cell size, 1/m
  ivec4 cells;     // xyz number of cells per axis; w index of the first cell in the common array of all meshes
  float cell;      // Cell size, m
  float unit;      // Metres per integer unit of the stored distances
  float grip;      // Fraction of the tangential velocity that remains after a substep
  float friction;  // Coulomb friction coefficient; if negative, `grip` applies instead
};

struct STD140 MeshColliders {
  MeshCollider meshes[maxMeshColliders];
  int count;
};

#endif

// Height grid of a mesh for collisions. Compiles as GLSL and as C++ (src/sim/mesh/height_plan.hpp). Set as plain
// uniforms, one member at a time.
#ifndef HEIGHT_TYPES
#define HEIGHT_TYPES

const int heightsBinding = 3;  // Binding point, also in the kernels that read the heights

struct HeightGrid {
  vec2 corner;     // x and z of vertex (0, 0), m
  vec2 perCell;    // 1 / cell size along x and z, 1/m
  ivec2 size;      // Number of vertices along x and z
  float progress;  // Elapsed fraction of the frame at the substep's end
  float perFrame;  // 1 / frame duration, 1/s
  float kept;      // Fraction of the tangential velocity kept
  float bounce;    // Fraction of the impact speed that is returned
  float margin;    // Distance kept above the surface, m
};

#endif

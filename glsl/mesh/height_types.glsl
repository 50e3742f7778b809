// Uniform data of a mesh's height grid for collisions. Compiles as GLSL and as C++ (src/sim/mesh/height_plan.hpp). The
// members are set as plain uniforms, one at a time.
#ifndef HEIGHT_TYPES
#define HEIGHT_TYPES

const int heightsBinding = 3;  // Binding point of the heights, also in the kernels that read them

struct HeightGrid {
  vec2 corner;     // x and z of vertex (0, 0), m
  vec2 perCell;    // 1 / cell size along x and z, 1/m
  ivec2 size;      // Number of vertices along x and z
  float progress;  // Elapsed fraction of the frame at the end of the substep
  float perFrame;  // 1 / frame duration, 1/s
  float kept;      // Fraction of the tangential velocity that remains
  float bounce;    // Fraction of the impact speed that remains after the bounce
  float margin;    // Distance kept above the surface, m
};

#endif

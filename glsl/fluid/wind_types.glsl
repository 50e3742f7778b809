// A fluid used as wind (wind_model.glsl). Compiles as GLSL and as C++ (src/sim/fluid/wind.hpp). Set as plain uniforms,
// one member at a time.
#ifndef FLUID_WIND_TYPES
#define FLUID_WIND_TYPES

const int windBinding = 8;  // Binding point in the kernels that read the wind

struct WindGrid {
  vec4 across;  // Row that maps a world point (m, 1) to x in cells, from the left side of the fluid's rectangle
  vec4 down;    // Row that maps a world point to y in cells, from the top side
  vec3 alongX;  // World vector of one cell to the right, m
  vec3 alongY;  // World vector of one cell down, m
  ivec2 size;   // Number of cells per axis
};

#endif

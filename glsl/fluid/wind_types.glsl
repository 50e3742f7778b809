// Uniform data of a fluid that acts as wind (wind_model.glsl). Compiles as GLSL and as C++ (src/sim/fluid/wind.hpp).
// The members are set as plain uniforms, one at a time.
#ifndef FLUID_WIND_TYPES
#define FLUID_WIND_TYPES

const int windBinding = 8;  // Binding point in the kernels that read the wind

struct WindGrid {
  vec4 across;  // Matrix row that maps a world point (x, y, z, 1), in metres, to x in cells, measured from the left
                // side of the fluid's rectangle
  vec4 down;    // Matrix row that maps a world point to y in cells, measured from the top side
  vec3 alongX;  // Vector of one cell to the right, in world space, in metres
  vec3 alongY;  // Vector of one cell down, in world space, in metres
  ivec2 size;   // Number of cells per axis
};

#endif

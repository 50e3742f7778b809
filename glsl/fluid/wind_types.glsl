// A fluid as the wind of others (wind_model.glsl). Compiles as GLSL and as C++ (src/sim/fluid/wind.hpp). Set as plain
// uniforms, one member at a time.
#ifndef FLUID_WIND_TYPES
#define FLUID_WIND_TYPES

const int windBinding = 8;  // of the kernels that read it: beside what they have

struct WindGrid {
  vec4 across;  // a world point (m, 1) times this is its x in cells, from the left side of the fluid's rectangle
  vec4 down;    // and its y, from the top side
  vec3 alongX;  // m: a cell to the right in the world
  vec3 alongY;  // and one down
  ivec2 size;   // cells
};

#endif

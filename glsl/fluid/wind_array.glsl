// Access to a fluid that acts as wind on other simulations. If WIND is not defined, nothing is bound or read, and
// `blown` is false.
#ifdef WIND
#include "fluid/wind_types.glsl"
const bool blown = true;
uniform WindGrid windGrid;
#ifdef TEXEL_PATH
INPUT_ARRAY(windBinding, WindBlock, windCells)
#else
// On the storage path, the buffer holds all u, then all v.
layout(std430, binding = windBinding) readonly restrict buffer WindBlock { float windCells[]; };
#endif

vec4 loadWindCell(int x, int y) {
  int i = (y + 1) * (windGrid.size.x + 2) + x + 1;
#ifdef TEXEL_PATH
  return LOAD_INPUT(windCells, i);
#else
  return vec4(windCells[i], windCells[(windGrid.size.x + 2) * (windGrid.size.y + 2) + i], 0.0, 0.0);
#endif
}
#include "fluid/wind_model.glsl"
#else
const bool blown = false;
vec3 windAt(vec3 here) {
  return vec3(0.0f);
}
#endif

// The fluid that a kernel's wind is, where WIND is defined; without, nothing is bound or read. `blown`: whether there is one.
#ifdef WIND
#include "fluid/wind_types.glsl"
const bool blown = true;
uniform WindGrid windGrid;
INPUT_ARRAY(windBinding, WindBlock, windCells)

vec4 loadWindCell(int x, int y) {
  return LOAD_INPUT(windCells, (y + 1) * (windGrid.size.x + 2) + x + 1);
}
#include "fluid/wind_model.glsl"
#else
const bool blown = false;
vec3 windAt(vec3 here) {
  return vec3(0.0f);
}
#endif

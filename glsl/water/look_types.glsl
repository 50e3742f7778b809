// Uniform data of look.comp. Compiles as GLSL and as C++.

struct STD140 WaterLook {
  float cell;        // Cell size, m
  float left;        // Position of the centre of cell (0, 0): x (left) and z (back), m
  float back;
  float base;        // Height of level 0, m
  float shallow;     // Depth below which water is not drawn, m
  float thin;        // Depth in metres below which water is thin
  float perClarity;  // Reciprocal of the depth that spans a quarter of the palette, 1/m
  float foam;        // Foam per unit of slope, for slopes above `calm`
  float calm;
};
const int depthColors = 64;
const int foamColors = 64;

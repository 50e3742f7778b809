// What the kernel is told that makes what is drawn. Compiles as GLSL and as C++.

struct STD140 WaterLook {
  float cell;        // m
  float left;        // of the middle of cell (0, 0) (m)
  float back;
  float base;        // height of level 0
  float shallow;     // m: what is thinner is not drawn
  float thin;        // m
  float perClarity;  // 1 / depth (1/m) for which the palette has depthColors / 4 colours
  float foam;        // foam for each unit of slope beyond `calm`
  float calm;
};
const int depthColors = 64;
const int foamColors = 64;

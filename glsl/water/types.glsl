// Uniform data of the shallow water kernels, and drops. Compiles as GLSL and as C++ (src/sim/water/plan.hpp).

// Kinds of boundary at a side of the grid.
const int wallEdge = 0;      // Wall: the mirror image of the border cells; no flow through the side
const int openEdge = 1;      // Open side: a copy of the border cell; waves leave the grid
const int periodicEdge = 2;  // Periodic side: continues at the opposite side
const int seaEdge = 3;       // Open sea: the waves of the sea enter, and outgoing waves leave

// Parameters of a step. A cell is a texel: x level (m), y and z discharge along the grid's x and y axes (m^2/s), w bed
// height (m).
struct STD140 WaterStep {
  float ratio;      // Time step divided by cell size, s/m
  float halfRatio;  // Half of `ratio`
  float gravity;    // Gravity in m/s^2
  float rain;       // Rainfall in the step, m
  float kept;       // Fraction of the discharge that remains after linear drag
  float manning;    // dt g n^2 in m^(1/3), where n is Manning's coefficient
  float thin;       // Depth below which the velocity is reduced, m
  float dry;        // Depth below which water does not move, m
  float share;      // 1 / (4 ratio) in m/s; limits the water that a cell gives away through a side
  float courant;    // Courant number above which the kernel triggers a remark
  int west;         // Boundary kind of each side
  int east;
  int north;
  int south;
  float sea;        // Level of the sea, m
  float seaWest;    // Height of the sea above `sea` beyond each side, m
  float seaEast;
  float seaNorth;
  float seaSouth;
};

// Drop that adds `height` (1 - r^2 / R^2)^2 to the level at the distance r from its centre, within the radius R, where
// there is water.
struct WaterDrop {
  vec2 center;       // Position of the centre in cells
  float perRadius2;  // 1 / squared radius, 1/cells^2
  float height;      // Rise of the level at the centre in metres
  float shallow;     // Depth below which the drop has no effect, m
};

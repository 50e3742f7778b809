// What a step of shallow water is told, and the drops that fall. Compiles as GLSL and as C++ (src/sim/water/plan.hpp).

// Kinds of boundary at a side of the grid.
const int wallEdge = 0;      // the mirror image: nothing flows through
const int openEdge = 1;      // the border cell again: what comes goes
const int periodicEdge = 2;  // the opposite side
const int seaEdge = 3;       // a wide sea: its waves come in, and what comes out is gone

// A cell is a texel: x level (m), y and z discharge along x and y (m^2/s), w bed (m).
struct STD140 WaterStep {
  float ratio;      // dt / side of a cell (s/m)
  float halfRatio;  // half of it
  float gravity;    // m/s^2
  float rain;       // m that fall in the step
  float kept;       // fraction of the discharge that linear drag leaves
  float manning;    // dt g n^2 (m^(1/3))
  float thin;       // m: the speed of what is thinner counts as less
  float dry;        // m: what is thinner stands still
  float share;      // 1 / (4 ratio) (m/s): of its depth that a cell gives away through a side at most
  float courant;    // (|u| + sqrt(g h)) dt / side beyond which the user is told
  int west;         // sides
  int east;
  int north;
  int south;
  float sea;        // m: the sea's level
  float seaWest;    // m: how much higher it stands beyond each side now
  float seaEast;
  float seaNorth;
  float seaSouth;
};

// Adds `height` (1 - r^2 / R^2)^2 to the level within R, where there is water.
struct WaterDrop {
  vec2 center;       // cells
  float perRadius2;  // 1 / R^2 (1/cells^2)
  float height;      // m
  float shallow;     // m: what is thinner is no water to fall into
};

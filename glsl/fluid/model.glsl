// Uniform data of the fluid kernels, and arithmetic that needs no access to cells. Compiles as GLSL and as C++
// (src/sim/fluid/plan.hpp). Lengths are in cells, so the cell width h is 1.
const int wallSide = 0;      // No-slip wall, which may move along itself
const int slipSide = 1;
const int inflowSide = 2;    // Side with a prescribed velocity
const int openSide = 3;      // Open side: pressure 0
const int periodicSide = 4;

// Data of one step.
struct STD140 FluidStep {
  vec4 leftRight;      // Velocity of the left side (xy) and of the right side (zw), cells/s
  vec4 topBottom;      // Velocity of the top side (xy) and of the bottom side (zw), cells/s
  float dt;            // Duration of the step in seconds
  float perDt;         // 1 / dt, in 1/s
  float viscosity;     // dt times the kinematic viscosity, cells^2
  float confinement;   // dt times the strength epsilon of the vorticity confinement
  float lift;          // dt times the acceleration at a temperature of 1
  float keptHeat;      // Fraction of the temperature that remains after dt
  float dyeDt;         // Duration of each dye pass in seconds
  float weight;        // dt times the downward acceleration of dye (1, 1, 1)
  vec4 parabolas;      // For each side (left, right, top, bottom): 1 if the inflow has a parabolic profile, otherwise 0
  vec4 confined;       // x: 2 / maximum expected speed, in s per cell; y, z and w are 0
};

// One level of the pressure solver's multigrid, with the element indices at which its data start.
struct STD140 FluidLevelPlace {
  ivec2 cells;
  int weights;       // Start of the level's face openings
  int rhs;           // Start of the level's right-hand side, in `pool`
  int way;           // Start of the level's correction on the way to coarser levels, in `raisedPool`
  int up;            // Start of the level's correction on the way to finer levels
  int coarseRhs;     // Start of the next coarser level's right-hand side
  int coarseUp;
  int openTiles;     // Start of the list of open tiles
  int otherTiles;    // Start of the list of the other tiles
  int otherRows;     // Number of rows of workgroups for the other tiles, if one dispatch processes both lists
  int spare0;
};

// Obstacles of a step, their motion, and the growth of closed pockets of fluid.
const int maxSolids = 255;
const int maxPockets = 255;
struct STD140 FluidSolid {
  vec4 place;     // xy centre of rotation, cells; z angular velocity, rad/s clockwise; w 0
  vec4 velocity;  // xy velocity of the centre, cells/s; zw 0
};
struct STD140 FluidSolidSet {
  FluidSolid solids[maxSolids + 1];
  vec4 growth[(maxPockets + 1) / 4];  // Required net outflow of each pocket divided by its area, in 1/s
};

// Distance in cells from a wall at which the fluid is sampled to extrapolate its velocity into the wall. At this
// distance, all four interpolated values are in the fluid.
const float wallReach = 1.5f;
const float perWallReach = 0.6666667f;
// Distance in cells from an obstacle's surface (negative inside) below which the velocity of a face does not affect the
// fluid.
const float deepWall = -2.5f;

// Brush with its effect. At most maxBrushes brushes act in a step.
const int maxBrushes = 16;
struct STD140 FluidBrush {
  vec4 segment;   // Start (xy) and end (zw) of the stroke (Stroke's from and to)
  // x radius2; y perLength2; z fraction by which values approach the target; w 1 / (radius2 - squared inner radius of
  // the soft rim), 0 for a hard brush
  vec4 reach;
  // xyz seed, picked and imageWord of Stroke; w bit mask of the quantities that the brush sets (1 velocity, 2
  // temperature, 4 dye)
  ivec4 stamp;
  ivec4 image;    // imageFrom and imageSize of Stroke
  ivec4 box;      // Cells that the brush may paint: first column, first row, number of columns, number of rows
  vec4 flow;      // xy velocity to set; z temperature to set; w 0
  vec4 force;     // xy velocity to add; zw 0
  vec4 dye;
};

// Number of sweeps on the coarsest level, and maximum number of cells on that level.
const int bottomSweeps = 24;
const int bottomCells = 64;
// Marks the correction of a cell without open faces.
const float noCell = 1e20f;
// Maximum fraction of a cell that dye crosses in a pass.
const float maxDyeWay = 0.25f;

// Returns the speed at face i of a side with `count` faces: constant, or a parabola with `speed` in the middle and 0 at
// the ends.
FUNCTION float sideSpeed(int i, int count, float speed, float parabola) {
  float each = exactReciprocal(float(count));
  precise float along = (float(i) + 0.5f) * each;
  precise float value = 4.0f * speed * (along * (1.0f - along));
  return parabola > 0.0f ? value : speed;
}

// Returns the weights of Lagrange interpolation at t for nodes at 0, 1, 2 and 3.
FUNCTION vec4 cubicWeights(float t) {
  precise float a = t - 1.0f;
  precise float b = t - 2.0f;
  precise float c = t - 3.0f;
  precise float first = -0.166666667f * (a * b * c);
  precise float second = 0.5f * (t * b * c);
  precise float third = -0.5f * (t * a * c);
  precise float fourth = 0.166666667f * (t * a * b);
  return vec4(first, second, third, fourth);
}

FUNCTION float between(float a, float b, float f) {
  precise float value = a + (b - a) * f;
  return value;
}

// Returns the distance of a cell's centre from obstacles, negative inside. The word holds the distance in its lower 16
// bits, then the obstacle's index (8 bits) and the pocket's index (8 bits).
FUNCTION float wallDistance(uint word) {
  precise float distance_ = float(int(word & 0xffffu) - 32768) * 0.00048828125f;
  return distance_;
}

// Returns the weights of a cell's left face and top face: the opening divided by the distance of the two cell centres.
// Each weight has 16 bits in the word.
FUNCTION vec2 faceWeights(uint word) {
  precise float left = float(int(word & 0xffffu)) * 0.000244140625f;
  precise float top = float(int(word >> 16u)) * 0.000244140625f;
  return vec2(left, top);
}

// Returns the sum of a cell's four face weights.
FUNCTION float diagonal(vec4 w) {
  precise float sum = (w.x + w.y) + (w.z + w.w);
  return sum;
}

FUNCTION float neighbours(vec4 w, float left, float right, float top, float bottom) {
  precise float sum = (w.x * left + w.y * right) + (w.z * top + w.w * bottom);
  return sum;
}

// Solve sum w (x - neighbour) = rhs for x in one cell. relaxing() returns the reciprocal of the diagonal; relaxedBy()
// and relaxed() return x.
FUNCTION float relaxing(float diag) {
  return exactReciprocal(max(diag, 1e-6f));
}

FUNCTION float relaxedBy(float each, float rhs, float sum, float diag) {
  precise float value = (rhs + sum) * each;
  return diag > 0.0f ? exactFlush(value) : noCell;
}

FUNCTION float relaxed(float rhs, float sum, float diag) {
  return relaxedBy(relaxing(diag), rhs, sum, diag);
}

// Returns the first value of a red cell on the way to coarser levels, for an initial value of zero. It is 1.5 times the
// value of relaxed(), because one sweep is not enough for smooth errors. A cycle then reduces a smooth error of a
// square to 1/7 instead of 1/6, at no cost.
FUNCTION float begun(float rhs, float diag) {
  float each = relaxing(diag);
  precise float value = 1.5f * (rhs * each);
  return diag > 0.0f ? exactFlush(value) : noCell;
}

// Returns rhs - sum w (value - neighbour). The differences are small compared with the values, so this form has smaller
// rounding errors.
FUNCTION float residual(float rhs, vec4 w, float value, float left, float right, float top, float bottom) {
  precise float rest = rhs - ((w.x * (value - left) + w.y * (value - right)) +
                              (w.z * (value - top) + w.w * (value - bottom)));
  return diagonal(w) > 0.0f ? exactFlush(rest) : 0.0f;
}

// Returns the rounding error of a + b (Knuth).
FUNCTION float lostInSum(float a, float b) {
  precise float sum = a + b;
  precise float ofB = sum - a;
  precise float ofA = sum - ofB;
  precise float lost = (a - ofA) + (b - ofB);
  return lost;
}

FUNCTION float added(float a, float b) {
  precise float sum = a + b;
  return sum;
}

// Returns the coarse right-hand side from the residuals of the coarse cell's first fine cell and fourth fine cell.
FUNCTION float restricted(float a, float b) {
  precise float sum = a + b;
  return sum;
}

// Interpolates bilinearly between the centres of coarse cells. A coarse cell that has no faces is replaced by `here`.
FUNCTION float prolonged(float here, float across, float down, float corner) {
  float x = across >= noCell ? here : across;
  float y = down >= noCell ? here : down;
  float xy = corner >= noCell ? here : corner;
  precise float value = (9.0f * here + 3.0f * (x + y) + xy) * 0.0625f;
  return here >= noCell ? 0.0f : value;
}

FUNCTION float raised(float value, float more) {
  precise float sum = value + more;
  return value >= noCell ? noCell : sum;
}

// Returns the overrelaxed value of a cell on the coarsest level: 1.5 times the change that relaxed() would make.
FUNCTION float overrelaxed(float before, float aim) {
  precise float value = before + 1.5f * (aim - before);
  return aim >= noCell ? noCell : exactFlush(value);
}

// Returns half of the maximum slope that creates no new extremum: van Leer's monotonized central limiter.
FUNCTION float limitedHalfSlope(float before, float after) {
  precise float quarter = 0.25f * (before + after);
  float both = max(min(before, after), min(max(before, after), 0.0f));  // 0 unless `before` and `after` have the same
                                                                        // sign
  float half_ = min(abs(both), abs(quarter));
  return both < 0.0f ? -half_ : half_;
}

// Dye is quantized in units of 2^-20, so that sums and differences below 16 are exact and dye is conserved. wholeDye()
// rounds towards zero, so that a cell never gives away more than it has.
const float perDyeUnit = 1048576.0f, dyeUnit = 9.5367431640625e-7f;
FUNCTION float wholeDye(float amount) {
  precise float units = amount * perDyeUnit;
  precise float whole = trunc(units) * dyeUnit;
  return whole;
}

// Returns the dye that crosses a face in a pass, before quantization. `way` is the fraction of a cell that the fluid
// crosses; `from` is the value of the upwind cell.
FUNCTION float dyeCarried(float way, float from, float halfSlope) {
  precise float far = 1.0f - abs(way);
  precise float amount = way * (from + (way > 0.0f ? far : -far) * halfSlope);
  return amount;
}

// Returns the quantized flux of dye through a face. a and b are the values of the two cells before the face, c and d
// are the values of the two cells after it.
FUNCTION float dyeFlux(float way, float a, float b, float c, float d) {
  bool on = way > 0.0f;
  precise float bc = c - b;
  precise float beyond = on ? b - a : d - c;
  return wholeDye(dyeCarried(way, on ? b : c, limitedHalfSlope(beyond, bc)));
}

FUNCTION vec4 dyeFluxes(float way, vec4 a, vec4 b, vec4 c, vec4 d) {
  return vec4(dyeFlux(way, a.x, b.x, c.x, d.x), dyeFlux(way, a.y, b.y, c.y, d.y),
              dyeFlux(way, a.z, b.z, c.z, d.z), 0.0f);
}

// Uniform data of the fluid kernels, and arithmetic that depends on values only. Compiles as GLSL and as C++
// (src/sim/fluid/plan.hpp). Lengths are in cells, h = 1.
const int wallSide = 0;      // Wall without slip; may move along itself
const int slipSide = 1;
const int inflowSide = 2;    // Side with a prescribed velocity
const int openSide = 3;      // Open side: pressure 0
const int periodicSide = 4;

// Data of one step.
struct STD140 FluidStep {
  vec4 leftRight;      // Velocity of the left side (xy) and of the right side (zw), cells/s
  vec4 topBottom;      // Velocity of the top side (xy) and of the bottom side (zw), cells/s
  float dt;            // in seconds
  float perDt;         // in 1/s
  float viscosity;     // dt times the kinematic viscosity, cells^2
  float confinement;   // dt times the strength epsilon of vorticity confinement
  float lift;          // dt times the acceleration at a temperature of 1
  float keptHeat;      // Fraction of temperature left after dt
  float dyeDt;         // Time step of each dye pass, s
  float weight;        // dt times the downward acceleration of dye (1, 1, 1)
  vec4 parabolas;      // Per side (left, right, top, bottom): 1 if the inflow has a parabolic profile
  vec4 confined;       // x: 2 / highest expected speed, in s per cell; the rest 0
};

// One level of the pressure solver's multigrid, and the element indices of its data.
struct STD140 FluidLevelPlace {
  ivec2 cells;
  int weights;       // Start of the level's face openings
  int rhs;           // Start of its right-hand side, in `pool`
  int way;           // Start of its correction on the way down, in `raisedPool`
  int up;            // Start of its correction on the way up
  int coarseRhs;     // Start of the coarser level's right-hand side
  int coarseUp;
  int openTiles;     // Start of the list of open tiles
  int otherTiles;    // Start of the list of the other tiles
  int otherRows;     // Rows of workgroups for the other tiles, if one dispatch processes both lists
  int spare0;
};

// Obstacles of a step and their motion, and the growth of closed pockets of fluid.
const int maxSolids = 255;
const int maxPockets = 255;
struct STD140 FluidSolid {
  vec4 place;     // xy centre of rotation, cells; z angular velocity, rad/s clockwise; w 0
  vec4 velocity;  // xy velocity of the centre, cells/s; zw 0
};
struct STD140 FluidSolidSet {
  FluidSolid solids[maxSolids + 1];
  vec4 growth[(maxPockets + 1) / 4];  // Net outflow of a pocket divided by its area, 1/s
};

// Distance from a wall at which the fluid is sampled to extrapolate into the wall: all four interpolated values then
// lie in the fluid.
const float wallReach = 1.5f;
const float perWallReach = 0.6666667f;
// Distance from an obstacle's surface (negative inside, in cells) below which the velocity of a face does not affect the
// fluid.
const float deepWall = -2.5f;

// Effect of a brush. At most maxBrushes act at once.
const int maxBrushes = 16;
struct STD140 FluidBrush {
  vec4 segment;   // Start and end of the stroke (Stroke's from and to)
  // x radius2; y perLength2; z fraction by which values approach the target; w 1 / (radius2 - squared inner radius of
  // the soft rim), 0 for a hard brush
  vec4 reach;
  // xyz seed, picked and imageWord of Stroke; w bit mask of what the brush sets (1 velocity, 2 temperature, 4 dye)
  ivec4 stamp;
  ivec4 image;    // imageFrom and imageSize of Stroke
  ivec4 box;      // Cells that it may paint: first column, first row, number of columns, number of rows
  vec4 flow;      // xy velocity to set; z temperature to set; w 0
  vec4 force;     // xy velocity to add; zw 0
  vec4 dye;
};

// Sweeps on the coarsest level, and its greatest number of cells.
const int bottomSweeps = 24;
const int bottomCells = 64;
// Marks the correction of a cell without open faces.
const float noCell = 1e20f;
// Greatest fraction of a cell that dye crosses in a pass.
const float maxDyeWay = 0.25f;

// Returns the speed at face i of `count` of a side: constant, or a parabola with `speed` in the middle and 0 at the
// ends.
FUNCTION float sideSpeed(int i, int count, float speed, float parabola) {
  float each = exactReciprocal(float(count));
  precise float along = (float(i) + 0.5f) * each;
  precise float value = 4.0f * speed * (along * (1.0f - along));
  return parabola > 0.0f ? value : speed;
}

// Returns the Lagrange weights at t for nodes at 0, 1, 2, 3.
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

// Returns the weights of a cell's left and top face: the opening divided by the distance of the two cell centres, 16
// bits each.
FUNCTION vec2 faceWeights(uint word) {
  precise float left = float(int(word & 0xffffu)) * 0.000244140625f;
  precise float top = float(int(word >> 16u)) * 0.000244140625f;
  return vec2(left, top);
}

// Returns the sum of a cell's face weights, given in the order left, right, top, bottom.
FUNCTION float diagonal(vec4 w) {
  precise float sum = (w.x + w.y) + (w.z + w.w);
  return sum;
}

FUNCTION float neighbours(vec4 w, float left, float right, float top, float bottom) {
  precise float sum = (w.x * left + w.y * right) + (w.z * top + w.w * bottom);
  return sum;
}

// Solution x of sum w (x - neighbour) = rhs for one cell: relaxing() returns the reciprocal of the diagonal;
// relaxedBy() and relaxed() return x.
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

// Returns the first value of a red cell on the way down, starting from zero. It goes 1.5 times as far as relaxed(),
// because smooth errors need more than one sweep. A cycle then leaves a seventh of a smooth error in a square, instead
// of a sixth, at no cost.
FUNCTION float begun(float rhs, float diag) {
  float each = relaxing(diag);
  precise float value = 1.5f * (rhs * each);
  return diag > 0.0f ? exactFlush(value) : noCell;
}

// Returns rhs - sum w (value - neighbour). The differences are small compared with the values, so this form rounds
// less.
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

// Returns the coarse right-hand side from the residuals of the coarse cell's first and fourth fine cells.
FUNCTION float restricted(float a, float b) {
  precise float sum = a + b;
  return sum;
}

// Interpolates bilinearly between the centres of coarse cells. A coarse cell without faces is replaced by `here`.
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

// Overrelaxed update on the coarsest level: goes 1.5 times as far as relaxed().
FUNCTION float overrelaxed(float before, float aim) {
  precise float value = before + 1.5f * (aim - before);
  return aim >= noCell ? noCell : exactFlush(value);
}

// Returns half of the steepest slope that creates no new extremum: van Leer's monotonized central limiter.
FUNCTION float limitedHalfSlope(float before, float after) {
  precise float quarter = 0.25f * (before + after);
  float both = max(min(before, after), min(max(before, after), 0.0f));  // 0 unless they have the same sign
  float half_ = min(abs(both), abs(quarter));
  return both < 0.0f ? -half_ : half_;
}

// Dye is quantized in units of 2^-20, so that sums and differences below 16 are exact and dye is conserved. Rounds
// towards zero, so that no cell gives away more than it has.
const float perDyeUnit = 1048576.0f, dyeUnit = 9.5367431640625e-7f;
FUNCTION float wholeDye(float amount) {
  precise float units = amount * perDyeUnit;
  precise float whole = trunc(units) * dyeUnit;
  return whole;
}

// Returns the dye that crosses a face in a pass, before quantization. `way` is the crossed fraction of a cell, `from`
// the value of the upwind cell.
FUNCTION float dyeCarried(float way, float from, float halfSlope) {
  precise float far = 1.0f - abs(way);
  precise float amount = way * (from + (way > 0.0f ? far : -far) * halfSlope);
  return amount;
}

// Returns the quantized flux through a face. a and b are the two cells before the face, c and d the two cells after it.
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

// What a fluid's kernels are told, and its arithmetic where that is a function of values. Compiles as GLSL and as C++
// (src/sim/fluid/plan.hpp). Lengths are in cells, h = 1.
const int wallSide = 0;      // no slip; may move along itself
const int slipSide = 1;
const int inflowSide = 2;    // velocity given
const int openSide = 3;      // pressure 0
const int periodicSide = 4;

// What each step is told.
struct STD140 FluidStep {
  vec4 leftRight;      // cells/s: velocity of the left side and of the right one
  vec4 topBottom;      // and of top and bottom
  float dt;            // s
  float perDt;         // 1/s
  float viscosity;     // dt nu
  float confinement;   // dt epsilon
  float lift;          // dt times the acceleration of a temperature of 1
  float keptHeat;      // fraction of temperature that is left after dt
  float dyeDt;         // s, of each pass of dye
  float weight;        // dt times the acceleration, down, of a dye of 1
  vec4 parabolas;      // of left, right, top and bottom: 1 where an inflow is a parabola between its ends
  vec4 confined;       // s a cell: 2 over the greatest speed that is expected; 0, 0, 0
};

// A level of the grids that solve for the pressure, and where in arrays what belongs to it starts; elements.
struct STD140 FluidLevelPlace {
  ivec2 cells;
  int weights;       // its openings,
  int rhs;           // what is missing, in `pool`,
  int way;           // its correction on the way down, in `raisedPool`,
  int up;            // and on the way up
  int coarseRhs;     // of the coarser level
  int coarseUp;
  int openTiles;     // the lists of tiles, those in the open,
  int otherTiles;    // and the others
  int otherRows;     // of groups for those, where both share a dispatch
  int spare0;
};

// What stands in a fluid, as it moves in a step, and what closed pockets of fluid have to give way by.
const int maxSolids = 255;
const int maxPockets = 255;
struct STD140 FluidSolid {
  vec4 place;     // cells: what it turns about; 1/s: how fast, clockwise; 0
  vec4 velocity;  // cells/s: of that place; 0, 0
};
struct STD140 FluidSolidSet {
  FluidSolid solids[maxSolids + 1];
  vec4 growth[(maxPockets + 1) / 4];  // 1/s: net flow out of a pocket over its area
};

// How far off a wall the fluid is looked at that says how it moves beyond it: all four values around are fluid's.
const float wallReach = 1.5f;
const float perWallReach = 0.6666667f;
// Faces within obstacles, so far from the fluid that nothing asks for their values.
const float deepWall = -2.5f;

// What a brush does. At most maxBrushes at once.
const int maxBrushes = 16;
struct STD140 FluidBrush {
  vec4 segment;   // Stroke's from and to
  vec4 reach;     // radius2, perLength2, the part of the way that values go, 1 / (radius2 less the rim's inner one); 0: hard
  ivec4 stamp;    // seed, picked, imageWord, which of velocity, temperature and dye it sets (1, 2, 4)
  ivec4 image;    // imageFrom, imageSize
  ivec4 box;      // cells that it may paint: first column and row, and how many of each
  vec4 flow;      // velocity that is set, temperature, 0
  vec4 force;     // velocity that is added, 0, 0
  vec4 dye;
};

// Of the coarsest level, which has at most so many cells.
const int bottomSweeps = 24;
const int bottomCells = 64;
// What cells without an open face have for a correction.
const float noCell = 1e20f;
// Part of a cell that dye crosses in a pass, at most.
const float maxDyeWay = 0.25f;

// Speed of a side's face i of `count`: even, or a parabola from 0 through `speed` in the middle to 0.
FUNCTION float sideSpeed(int i, int count, float speed, float parabola) {
  float each = exactReciprocal(float(count));
  precise float along = (float(i) + 0.5f) * each;
  precise float value = 4.0f * speed * (along * (1.0f - along));
  return parabola > 0.0f ? value : speed;
}

// Lagrange's of four points at 0, 1, 2, 3.
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

// How far a cell's middle is off obstacles, negative within: its lower 16 bits. Above: which obstacle, 8 bits, and pocket.
FUNCTION float wallDistance(uint word) {
  precise float distance_ = float(int(word & 0xffffu) - 32768) * 0.00048828125f;
  return distance_;
}

// Openings of a cell's left and top face over the distance of the cells there, 16 bits each.
FUNCTION vec2 faceWeights(uint word) {
  precise float left = float(int(word & 0xffffu)) * 0.000244140625f;
  precise float top = float(int(word >> 16u)) * 0.000244140625f;
  return vec2(left, top);
}

// Weights of a cell's faces: left, right, top, bottom.
FUNCTION float diagonal(vec4 w) {
  precise float sum = (w.x + w.y) + (w.z + w.w);
  return sum;
}

FUNCTION float neighbours(vec4 w, float left, float right, float top, float bottom) {
  precise float sum = (w.x * left + w.y * right) + (w.z * top + w.w * bottom);
  return sum;
}

// The x of a cell that fulfils sum w (x - neighbour) = rhs, given what its diagonal makes of that.
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

// Of a red cell on the way down, from no correction: farther than relaxed(), as what is smooth lies farther than one sweep goes. A
// cycle then leaves less, for nothing (of a square's smooth flow a seventh, not a sixth).
FUNCTION float begun(float rhs, float diag) {
  float each = relaxing(diag);
  precise float value = 1.5f * (rhs * each);
  return diag > 0.0f ? exactFlush(value) : noCell;
}

// rhs - sum w (value - neighbour): by differences, which are small beside the values.
FUNCTION float residual(float rhs, vec4 w, float value, float left, float right, float top, float bottom) {
  precise float rest = rhs - ((w.x * (value - left) + w.y * (value - right)) +
                              (w.z * (value - top) + w.w * (value - bottom)));
  return diagonal(w) > 0.0f ? exactFlush(rest) : 0.0f;
}

// What a sum of two floats loses (Knuth).
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

// The residuals of a coarse cell's first and fourth.
FUNCTION float restricted(float a, float b) {
  precise float sum = a + b;
  return sum;
}

// Linear in both directions between the middles of coarse cells; where there is no cell, as here.
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

// One sweep of the coarsest level goes farther than to relaxed().
FUNCTION float overrelaxed(float before, float aim) {
  precise float value = before + 1.5f * (aim - before);
  return aim >= noCell ? noCell : exactFlush(value);
}

// Half the steepest slope that makes no new extremes: van Leer's monotonized central one.
FUNCTION float limitedHalfSlope(float before, float after) {
  precise float quarter = 0.25f * (before + after);
  float both = max(min(before, after), min(max(before, after), 0.0f));  // 0 unless they have the same sign
  float half_ = min(abs(both), abs(quarter));
  return both < 0.0f ? -half_ : half_;
}

// Dye comes in units of 2^-20: so sums and differences of what is below 16 are exact, and none is made or lost by
// rounding. Towards zero, so that no cell gives more than it has.
const float perDyeUnit = 1048576.0f, dyeUnit = 9.5367431640625e-7f;
FUNCTION float wholeDye(float amount) {
  precise float units = amount * perDyeUnit;
  precise float whole = trunc(units) * dyeUnit;
  return whole;
}

// What crosses a face in a pass, before it is cut to whole units: `way` of a cell, of the cell it comes from.
FUNCTION float dyeCarried(float way, float from, float halfSlope) {
  precise float far = 1.0f - abs(way);
  precise float amount = way * (from + (way > 0.0f ? far : -far) * halfSlope);
  return amount;
}

// a, b | c, d are two cells before the face and two after it.
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

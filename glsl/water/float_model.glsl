// Bodies with six degrees of freedom on shallow water. Compiles as GLSL and as C++ (tests/reference/water_twin.cpp), after
// common/exact.glsl, water/model.glsl and water/float_types.glsl. Whoever includes it provides `floats` (FloatStep), `size`
// (ivec2, cells), loadWater(int i), loadFloat(int i), loadTold(int i), loadFloatPoint(int i), texels all, and
// addToSum(int cell, int which, int value).
//
//   M dv/dt = sum over points of rho g V f (-w_x, 1, -w_z) - M k (v - u) + contact - M g,     dL/dt = sum r x F
//
// Each point stands for a cuboid of the body, f the share of it below the water's level w (Archimedes: the integral of the
// pressure over the surface is that of its gradient over the volume). The water's level counts what a body displaces as
// water: a body that goes down by some volume raises the level by as much where it does so, and takes it back when it leaves.
// What pushes a body along is taken from the water's discharge, so their momentum stays.
//
// A body displaces its volume under a reference level r, which follows the mean level w of the water over it:
//
//   T m1' = w - m1,   T m2' = m1 - m2,   T r' = m2 - r
//
// A rising r adds water where the level is w, so r' does the work rho g A (w - r) r' on the water (A: area of its section). At
// the frequency f = omega T that is proportional to Re(i f / (1 + i f)^3) = f^2 (3 - f^2) / (1 + f^2)^3, which is negative for
// f > sqrt(3): T is so long that the slowest wave of the grid has f = 2, and following never feeds a wave. A single stage
// always does.

struct FloatBody {
  vec3 at;        // m
  float level;    // m: reference level
  vec4 turn;      // quaternion
  vec3 velocity;  // m/s
  float under;    // m^3 under that level
  vec3 spin;      // angular momentum (kg m^2/s)
  vec2 stages;    // m: of the reference level
  float around;   // m: mean level of the water over its points
  float wet;      // m^3 under the water
};

FUNCTION FloatBody floatBody(int i) {
  vec4 a = loadFloat(i * floatTexels), b = loadFloat(i * floatTexels + 2);
  FloatBody body;
  body.at = vec3(a);
  body.level = a.w;
  body.turn = loadFloat(i * floatTexels + 1);
  body.velocity = vec3(b);
  body.under = b.w;
  body.spin = vec3(loadFloat(i * floatTexels + 3));
  vec4 e = loadFloat(i * floatTexels + 4);
  body.stages = vec2(e.x, e.y);
  body.around = e.z;
  body.wet = e.w;
  return body;
}

FUNCTION FloatTold floatTold(int i) {
  int first = i * floatToldTexels;
  FloatTold t;
  t.mass = loadTold(first);
  t.turnA = loadTold(first + 1);
  t.turnB = loadTold(first + 2);
  t.grain = loadTold(first + 3);
  t.drag = loadTold(first + 4);
  t.reach = loadTold(first + 5);
  t.tow = loadTold(first + 6);
  t.head = loadTold(first + 7);
  t.pull = loadTold(first + 8);
  t.meet = loadTold(first + 9);
  t.field = loadTold(first + 10);
  t.nodes = loadTold(first + 11);
  return t;
}

// v turned by the quaternion q: v + 2 q x (q x v + w v).
FUNCTION vec3 floatTurned(vec4 q, vec3 v) {
  vec3 axis = vec3(q);
  precise vec3 inner = exactCross(axis, v) + q.w * v;
  precise vec3 turned = v + 2.0f * exactCross(axis, inner);
  return turned;
}
FUNCTION vec3 floatTurnedBack(vec4 q, vec3 v) {
  return floatTurned(vec4(-q.x, -q.y, -q.z, q.w), v);
}

// Angular velocity of an angular momentum: R I^-1 R^T L.
FUNCTION vec3 floatTurning(FloatTold t, vec4 q, vec3 spin) {
  vec3 own = floatTurnedBack(q, spin);
  precise float x = t.turnA.x * own.x + t.turnB.x * own.y + t.turnB.y * own.z;
  precise float y = t.turnB.x * own.x + t.turnA.y * own.y + t.turnB.z * own.z;
  precise float z = t.turnB.y * own.x + t.turnB.z * own.y + t.turnA.z * own.z;
  return floatTurned(q, vec3(x, y, z));
}

// How wide along x, y and z a turned cuboid of these sides is.
FUNCTION vec3 floatExtent(vec4 q, vec3 sides) {
  vec3 a = floatTurned(q, vec3(sides.x, 0.0f, 0.0f));
  vec3 b = floatTurned(q, vec3(0.0f, sides.y, 0.0f));
  vec3 c = floatTurned(q, vec3(0.0f, 0.0f, sides.z));
  precise vec3 extent = abs(a) + abs(b) + abs(c);
  return extent;
}

// The cell that counts at a place beyond the grid, too: the nearest, or on the other side.
FUNCTION int floatColumn(int x) {
  int count = size.x;
  if (floats.west == periodicEdge) return x < 0 ? x + count : x >= count ? x - count : x;
  return clamp(x, 0, count - 1);
}
FUNCTION int floatRow(int y) {
  int count = size.y;
  if (floats.north == periodicEdge) return y < 0 ? y + count : y >= count ? y - count : y;
  return clamp(y, 0, count - 1);
}

// The water at a place, between four cells; those that are dry do not count.
struct FloatWater {
  float share;   // of cells that are wet
  float level;   // m
  float slopeX;  // of the level
  float slopeZ;
  float depth;   // m
  float u;       // m/s
  float v;
  float bed;     // m
  float bedX;    // its slope
  float bedZ;
};

FUNCTION FloatWater floatWater(float column, float row) {
  precise float left = column - 0.5f;
  precise float top = row - 0.5f;
  float wholeX = clamp(floor(left), -1.0f, float(size.x));
  float wholeY = clamp(floor(top), -1.0f, float(size.y));
  precise float partX = left - wholeX;
  precise float partY = top - wholeY;
  partX = clamp(partX, 0.0f, 1.0f);
  partY = clamp(partY, 0.0f, 1.0f);
  int x0 = floatColumn(int(wholeX)), x1 = floatColumn(int(wholeX) + 1);
  int y0 = floatRow(int(wholeY)), y1 = floatRow(int(wholeY) + 1);
  vec4 a = loadWater(y0 * size.x + x0), b = loadWater(y0 * size.x + x1);
  vec4 c = loadWater(y1 * size.x + x0), d = loadWater(y1 * size.x + x1);
  precise float restX = 1.0f - partX;
  precise float restY = 1.0f - partY;
  precise float wa = restX * restY;
  precise float wb = partX * restY;
  precise float wc = restX * partY;
  precise float wd = partX * partY;
  FloatWater w;
  precise float bed = wa * a.w + wb * b.w + wc * c.w + wd * d.w;
  precise float bedX = ((b.w - a.w) * restY + (d.w - c.w) * partY) * floats.perCell;
  precise float bedZ = ((c.w - a.w) * restX + (d.w - b.w) * partX) * floats.perCell;
  precise float da = a.x - a.w;
  precise float db = b.x - b.w;
  precise float dc = c.x - c.w;
  precise float dd = d.x - d.w;
  bool all_ = da > floats.dry && db > floats.dry && dc > floats.dry && dd > floats.dry;
  precise float slopeX = ((b.x - a.x) * restY + (d.x - c.x) * partY) * floats.perCell;
  precise float slopeZ = ((c.x - a.x) * restX + (d.x - b.x) * partX) * floats.perCell;
  wa = da > floats.dry ? wa : 0.0f;
  wb = db > floats.dry ? wb : 0.0f;
  wc = dc > floats.dry ? wc : 0.0f;
  wd = dd > floats.dry ? wd : 0.0f;
  precise float share = (wa + wb) + (wc + wd);
  float inverse = exactReciprocal(max(share, 1e-3f));
  // From the first of the cells, so that an even level stays what it is.
  precise float risen = (wb * (b.x - a.x) + wc * (c.x - a.x)) + wd * (d.x - a.x);
  precise float level = a.x + risen * inverse;
  precise float depth = ((wa * da + wb * db) + (wc * dc + wd * dd)) * inverse;
  precise float qx = ((wa * a.y + wb * b.y) + (wc * c.y + wd * d.y)) * inverse;
  precise float qy = ((wa * a.z + wb * b.z) + (wc * c.z + wd * d.z)) * inverse;
  WaterCell moving = waterCell(vec4(depth, qx, qy, 0.0f), floats.thin);
  w.share = share >= 1e-3f ? share : 0.0f;
  w.level = level;
  w.slopeX = all_ ? slopeX : 0.0f;
  w.slopeZ = all_ ? slopeZ : 0.0f;
  w.depth = depth;
  w.u = moving.u;
  w.v = moving.v;
  w.bed = bed;
  w.bedX = bedX;
  w.bedZ = bedZ;
  return w;
}

// Sums over the points of a body.
struct FloatSum {
  vec4 push;  // force (N), volume under the reference level (m^3)
  vec4 turn;  // moment (N m), volume over wet cells (m^3)
  vec4 rest;  // that volume times its level over the reference level (m^4), volume under the water (m^3), unused
};

// What touches pushes a point of mass 1 with unit normal n, `deep` m within, by this acceleration, Coulomb's friction along.
FUNCTION vec3 floatTouch(vec3 n, float deep, vec3 velocity, float friction) {
  precise float into = exactDot(n, velocity);
  float held = min(deep, floats.deepest);
  precise float push = floats.stiff * held - floats.damp * into;
  push = deep > 0.0f ? max(push, 0.0f) : 0.0f;
  precise vec3 along = velocity - into * n;
  precise float slip = exactDot(along, along);
  precise float most = friction * push * exactInverseSqrt(max(slip, 1e-12f));
  most = min(most, floats.damp);
  precise vec3 acceleration = push * n - most * along;
  return acceleration;
}

// Adds a point's displaced volume and its pull on the water to the cells below its cuboid, by the area that they share.
FUNCTION void floatSpread(FloatBody body, float column, float row, vec2 wide, vec2 per, float volume, vec2 force) {
  precise float x0 = column - wide.x;
  precise float x1 = column + wide.x;
  precise float y0 = row - wide.y;
  precise float y1 = row + wide.y;
  int left = int(floor(x0)), right = int(floor(x1)), top = int(floor(y0)), bottom = int(floor(y1));
  bool torusX = floats.west == periodicEdge, torusY = floats.north == periodicEdge;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      bool outX = x < 0 || x >= size.x, outY = y < 0 || y >= size.y;
      bool beyond = (outX && !torusX) || (outY && !torusY);
      int cell = floatRow(y) * size.x + floatColumn(x);
      precise float nextX = float(x) + 1.0f;
      precise float nextY = float(y) + 1.0f;
      precise float across = min(x1, nextX) - max(x0, float(x));
      precise float down = min(y1, nextY) - max(y0, float(y));
      across = max(across, 0.0f);
      down = max(down, 0.0f);
      precise float share = (across * per.x) * (down * per.y);
      precise float raised = volume * share * floats.perDepthUnit + 0.5f;
      precise float pullX = force.x * share * floats.perFlowUnit + 0.5f;
      precise float pullY = force.y * share * floats.perFlowUnit + 0.5f;
      int units = int(floor(raised)), flowX = int(floor(pullX)), flowY = int(floor(pullY));
      if (units != 0 && !beyond && loadWater(cell).w < body.level) addToSum(cell, 0, units);
      if (flowX != 0) addToSum(cell, 1, -flowX);
      if (flowY != 0) addToSum(cell, 2, -flowY);
    }
}

// Point i of a body. `drive`: its own push for each m^3 under water (N/m^3); `steering`: the same of a push about its middle, for each m off it;
// `turning`: its angular velocity; `extent`: floatExtent of a point's cuboid.
FUNCTION FloatSum floatPoint(int i, FloatBody body, FloatTold t, vec3 turning, vec3 drive, vec3 steering, vec3 extent, vec2 wide,
                             vec2 per) {
  vec4 point = loadFloatPoint(i);
  vec3 arm = floatTurned(body.turn, vec3(point));
  precise vec3 at = body.at + arm;
  precise vec3 velocity = body.velocity + exactCross(turning, arm);
  precise float column = at.x * floats.perCell + floats.columns;
  precise float row = at.z * floats.perCell + floats.rows;
  FloatWater water = floatWater(column, row);
  float perHeight = exactReciprocal(max(extent.y, 1e-6f));
  precise float under = (water.level - at.y) * perHeight + 0.5f;
  under = water.share > 0.0f ? clamp(under, 0.0f, 1.0f) : 0.0f;
  precise float lift = floats.density * floats.gravity * point.w * under;
  // Drag as if the point moved by itself, implicit, so that it never turns round what it slows down.
  precise vec3 against = velocity - vec3(water.u, 0.0f, water.v);
  vec3 side = floatTurned(body.turn, vec3(1.0f, 0.0f, 0.0f));
  precise float sideways = exactDot(against, side) * t.drag.z;
  against = against + sideways * side;
  precise float squared = exactDot(against, against);
  precise float rate = (t.drag.x + t.drag.y * exactSqrt(squared)) * under;
  precise float laden = 1.0f + t.drag.w * exactReciprocal(max(water.depth, floats.thin));
  precise float damped = 1.0f + rate * floats.dt * laden * (1.0f + t.drag.z);
  precise float mass = t.mass.x * point.w * exactReciprocal(t.grain.w);
  precise float slowed = mass * rate * exactReciprocal(damped);
  precise float pushX = -lift * water.slopeX - slowed * against.x;
  precise float pushY = lift - slowed * against.y;
  precise float pushZ = -lift * water.slopeZ - slowed * against.z;
  precise float around = (body.level - at.y) * perHeight + 0.5f;
  around = clamp(around, 0.0f, 1.0f);
  precise float volume = point.w * around;
  precise float works = point.w * under;
  precise vec3 own = drive * works;
  precise vec3 aside = exactCross(steering, arm) * works;
  precise float pullX = pushX + (own.x + aside.x);
  precise float pullZ = pushZ + (own.z + aside.z);
  floatSpread(body, column, row, wide, per, volume, vec2(pullX, pullZ));
  // The ground, and walls at the grid's sides.
  precise float steep = 1.0f + water.bedX * water.bedX + water.bedZ * water.bedZ;
  float upright = exactInverseSqrt(steep);
  precise vec3 normal = vec3(-water.bedX * upright, upright, -water.bedZ * upright);
  precise float deep = (water.bed + 0.5f * extent.y - at.y) * upright;
  precise float low = -floats.halfX - at.x;
  precise float high = at.x - floats.halfX;
  precise float back = -floats.halfZ - at.z;
  precise float front = at.z - floats.halfZ;
  low = floats.west == wallEdge ? low : 0.0f;
  high = floats.east == wallEdge ? high : 0.0f;
  back = floats.north == wallEdge ? back : 0.0f;
  front = floats.south == wallEdge ? front : 0.0f;
  precise vec3 touch = vec3(0.0f, 0.0f, 0.0f);
  if (deep > 0.0f) touch = touch + floatTouch(normal, deep, velocity, t.reach.z);
  if (low > 0.0f) touch = touch + floatTouch(vec3(1.0f, 0.0f, 0.0f), low, velocity, t.reach.z);
  if (high > 0.0f) touch = touch + floatTouch(vec3(-1.0f, 0.0f, 0.0f), high, velocity, t.reach.z);
  if (back > 0.0f) touch = touch + floatTouch(vec3(0.0f, 0.0f, 1.0f), back, velocity, t.reach.z);
  if (front > 0.0f) touch = touch + floatTouch(vec3(0.0f, 0.0f, -1.0f), front, velocity, t.reach.z);
  precise vec3 force = (vec3(pushX, pushY, pushZ) + aside) + mass * touch;
  vec3 moment = exactCross(arm, force);
  force = force + own;  // as if at the middle of mass
  precise float wet = water.share > 0.0f ? point.w : 0.0f;
  precise float risen = wet * (water.level - body.level);
  FloatSum sum;
  sum.push = vec4(force, volume);
  sum.turn = vec4(moment, wet);
  sum.rest = vec4(risen, works, 0.0f, 0.0f);
  return sum;
}

FUNCTION FloatSum floatAdded(FloatSum a, FloatSum b) {
  precise vec4 push = a.push + b.push;
  precise vec4 turn = a.turn + b.turn;
  precise vec4 rest = a.rest + b.rest;
  FloatSum sum;
  sum.push = push;
  sum.turn = turn;
  sum.rest = rest;
  return sum;
}

// What one lane of a body adds up, in order.
FUNCTION FloatSum floatLane(int lane, FloatBody body, FloatTold t) {
  vec3 turning = floatTurning(t, body.turn, body.spin);
  vec3 extent = floatExtent(body.turn, vec3(t.grain));
  precise float cellsX = extent.x * floats.perCell;
  precise float cellsY = extent.z * floats.perCell;
  precise float wideX = 0.5f * max(cellsX, 1.0f);
  precise float wideY = 0.5f * max(cellsY, 1.0f);
  precise float perX = 0.5f * exactReciprocal(wideX);
  precise float perY = 0.5f * exactReciprocal(wideY);
  // Its own push, shared out by what of it was under water a step ago: it works there only, and the water gets the opposite.
  precise float least = 0.02f * t.grain.w;
  precise float thrust = t.reach.w * exactReciprocal(max(body.wet, least));
  precise vec3 drive = thrust * floatTurned(body.turn, vec3(0.0f, 0.0f, 1.0f));
  precise float swing = t.head.z * exactReciprocal(max(body.wet, least));
  precise vec3 steering = swing * floatTurned(body.turn, vec3(0.0f, 1.0f, 0.0f));
  FloatSum sum;
  sum.push = vec4(0.0f);
  sum.turn = vec4(0.0f);
  sum.rest = vec4(0.0f);
  for (int i = int(t.turnA.w) + lane; i < int(t.turnB.w); i += floatLanes)
    sum = floatAdded(sum, floatPoint(i, body, t, turning, drive, steering, extent, vec2(wideX, wideY), vec2(perX, perY)));
  return sum;
}

// Rigid bodies with six degrees of freedom on shallow water. Compiles as GLSL and as C++
// (tests/reference/water_twin.cpp), after common/exact.glsl, water/model.glsl and water/float_types.glsl. The including
// file provides `floats` (FloatStep), `size` (ivec2, cells), loadWater(int i), loadFloat(int i), loadParameters(int i),
// loadFloatPoint(int i) (all return texels), and addToSum(int cell, int which, int value).
//
//   M dv/dt = sum over points of rho g V f (-w_x, 1, -w_z) - M k (v - u) + contact - M g,     dL/dt = sum r x F
//
// Each point represents a cuboid of the body; f is its fraction below the water level w (Archimedes: the surface
// integral of the pressure equals the volume integral of its gradient). The stored water level includes the displaced
// volume: a body that sinks by some volume raises the level by this volume in its cells, and lowers it again when it
// leaves. Forces that push a body horizontally are subtracted from the water's discharge, so momentum is conserved.
//
// A body displaces its volume below a reference level r. The reference level follows w, the mean level of the water
// over the body, in three stages:
//
//   T m1' = w - m1,   T m2' = m1 - m2,   T r' = m2 - r
//
// A rising r adds water where the level is w, so r' does the work rho g A (w - r) r' on the water (A: area of the
// body's section). At the frequency f = omega T this is proportional to Re(i f / (1 + i f)^3) = f^2 (3 - f^2) / (1 +
// f^2)^3, which is negative for f > sqrt(3). T is so long that the slowest wave of the grid has f = 2, so the body
// never feeds energy to a wave. A single stage would always feed energy.

struct FloatBody {
  vec3 at;        // Centre of mass, m
  float level;    // Reference level, m
  vec4 turn;      // Rotation, a quaternion
  vec3 velocity;  // Velocity in m/s
  float under;    // Volume below the reference level, m^3
  vec3 spin;      // Angular momentum, kg m^2/s
  vec2 stages;    // First two stages of the reference level, m
  float around;   // Mean water level over the body's points, m
  float wet;      // Volume below the water level, m^3
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

FUNCTION FloatParameters floatParameters(int i) {
  int first = i * floatParameterTexels;
  FloatParameters t;
  t.mass = loadParameters(first);
  t.turnA = loadParameters(first + 1);
  t.turnB = loadParameters(first + 2);
  t.grain = loadParameters(first + 3);
  t.drag = loadParameters(first + 4);
  t.reach = loadParameters(first + 5);
  t.tow = loadParameters(first + 6);
  t.head = loadParameters(first + 7);
  t.pull = loadParameters(first + 8);
  t.meet = loadParameters(first + 9);
  t.field = loadParameters(first + 10);
  t.nodes = loadParameters(first + 11);
  return t;
}

// Rotates v by the quaternion q = (q.xyz, w): v + 2 q x (q x v + w v).
FUNCTION vec3 floatTurned(vec4 q, vec3 v) {
  vec3 axis = vec3(q);
  precise vec3 inner = exactCross(axis, v) + q.w * v;
  precise vec3 turned = v + 2.0f * exactCross(axis, inner);
  return turned;
}
FUNCTION vec3 floatTurnedBack(vec4 q, vec3 v) {
  return floatTurned(vec4(-q.x, -q.y, -q.z, q.w), v);
}

// Returns the angular velocity R I^-1 R^T L for an angular momentum L, where R is the body's rotation and I the inertia
// tensor.
FUNCTION vec3 floatTurning(FloatParameters t, vec4 q, vec3 spin) {
  vec3 own = floatTurnedBack(q, spin);
  precise float x = t.turnA.x * own.x + t.turnB.x * own.y + t.turnB.y * own.z;
  precise float y = t.turnB.x * own.x + t.turnA.y * own.y + t.turnB.z * own.z;
  precise float z = t.turnB.y * own.x + t.turnB.z * own.y + t.turnA.z * own.z;
  return floatTurned(q, vec3(x, y, z));
}

// Returns the extents along x, y and z of a rotated cuboid with the side lengths `sides`.
FUNCTION vec3 floatExtent(vec4 q, vec3 sides) {
  vec3 a = floatTurned(q, vec3(sides.x, 0.0f, 0.0f));
  vec3 b = floatTurned(q, vec3(0.0f, sides.y, 0.0f));
  vec3 c = floatTurned(q, vec3(0.0f, 0.0f, sides.z));
  precise vec3 extent = abs(a) + abs(b) + abs(c);
  return extent;
}

// Return the column or the row to use for an index beyond the grid: the nearest one, or on a torus the wrapped one.
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

// Water at a point, interpolated between four cells without the dry ones.
struct FloatWater {
  float share;   // Sum of the interpolation weights of wet cells
  float level;   // Water level, m
  float slopeX;  // Slope of the level along x
  float slopeZ;
  float depth;   // Depth in metres
  float u;       // Velocity along x in m/s
  float v;
  float bed;     // Ground height, m
  float bedX;    // Slope of the ground along x
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
  // Interpolates differences from the first cell, so that a constant level is reproduced exactly.
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
  vec4 push;  // xyz force (N); w volume below the reference level (m^3)
  vec4 turn;  // xyz moment (N m); w volume over wet cells (m^3)
  // x volume over wet cells times (water level - reference level) (m^4); y volume below the water level (m^3); zw
  // unused
  vec4 rest;
};

// Returns the contact acceleration of a point at the depth `deep` (metres) below a surface with the unit normal n,
// including Coulomb friction along the surface.
FUNCTION vec3 floatTouch(vec3 n, float deep, vec3 velocity, float friction) {
  precise float into = exactDot(n, velocity);
  float held = min(deep, floats.deepest);
  precise float push = floats.stiff * held - floats.damp * into;
  push = deep > 0.0f ? max(push, 0.0f) : 0.0f;
  precise vec3 along = velocity - into * n;
  precise float slip = exactDot(along, along);
  precise float maximum = friction * push * exactInverseSqrt(max(slip, 1e-12f));
  maximum = min(maximum, floats.damp);
  precise vec3 acceleration = push * n - maximum * along;
  return acceleration;
}

// Distributes a point's displaced volume and its horizontal force over the cells below its cuboid, in proportion to the
// overlap areas.
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

// Returns what point i adds to the sums of its body: force, moment and volumes. Adds the point's displaced volume, and
// the force opposite to its horizontal force on the body without contact, to the sums of the grid's cells
// (floatSpread()). `t`: the body's parameters. `turning`: the body's angular velocity (rad/s). `drive`: the body's
// thrust per volume under water (N/m^3). `steering`: the body's steering moment as a force density per metre of
// distance from the body's axis. `extent`: size (m) of the axis-aligned box around a point's rotated cuboid
// (floatExtent()). `wide`: half of the box's size in cells along x and z, at least 0.5. `per`: 1 / (2 wide).
FUNCTION FloatSum floatPoint(int i, FloatBody body, FloatParameters t, vec3 turning, vec3 drive, vec3 steering, vec3 extent, vec2 wide,
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
  // The drag acts on the point as if it moved independently. It is integrated implicitly, so that it never reverses the
  // relative motion.
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
  // Adds the contact with the ground and with walls at the grid's sides.
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
  force = force + own;  // Thrust acts at the centre of mass, so it adds no moment.
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

// Sums the forces on the points of one lane of a body in a fixed order.
FUNCTION FloatSum floatLane(int lane, FloatBody body, FloatParameters t) {
  vec3 turning = floatTurning(t, body.turn, body.spin);
  vec3 extent = floatExtent(body.turn, vec3(t.grain));
  precise float cellsX = extent.x * floats.perCell;
  precise float cellsY = extent.z * floats.perCell;
  precise float wideX = 0.5f * max(cellsX, 1.0f);
  precise float wideY = 0.5f * max(cellsY, 1.0f);
  precise float perX = 0.5f * exactReciprocal(wideX);
  precise float perY = 0.5f * exactReciprocal(wideY);
  // Distributes the body's thrust over the volume that was under water in the previous step, because thrust acts only
  // there. The water receives the opposite force.
  precise float minimum = 0.02f * t.grain.w;
  precise float thrust = t.reach.w * exactReciprocal(max(body.wet, minimum));
  precise vec3 drive = thrust * floatTurned(body.turn, vec3(0.0f, 0.0f, 1.0f));
  precise float swing = t.head.z * exactReciprocal(max(body.wet, minimum));
  precise vec3 steering = swing * floatTurned(body.turn, vec3(0.0f, 1.0f, 0.0f));
  FloatSum sum;
  sum.push = vec4(0.0f);
  sum.turn = vec4(0.0f);
  sum.rest = vec4(0.0f);
  for (int i = int(t.turnA.w) + lane; i < int(t.turnB.w); i += floatLanes)
    sum = floatAdded(sum, floatPoint(i, body, t, turning, drive, steering, extent, vec2(wideX, wideY), vec2(perX, perY)));
  return sum;
}

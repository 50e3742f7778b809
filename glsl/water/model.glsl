// One step of the shallow water equations in one cell, in exact arithmetic. Compiles as GLSL and as C++
// (src/sim/water/plan.hpp), after common/exact.glsl and water/types.glsl.
//
//   h_t + (hu)_x + (hv)_y = rain
//   (hu)_t + (hu^2 + g h^2 / 2)_x + (huv)_y = -g h b_x - friction,    the same for hv,    level w = h + b
//
// Finite volumes, MUSCL-Hancock: limited slopes of level, depth and velocity, half a step in each cell by
// itself, then HLL fluxes between what hydrostatic reconstruction leaves of both sides of a face (Audusse, Bouchut,
// Bristeau, Klein and Perthame 2004; Toro 2001 for wave speeds). The level is what is stored: where it is even and nothing
// moves, every term below is exactly zero, whatever the bed does.

struct WaterCell {
  float level;  // m
  float depth;  // m, not negative
  float u;      // m/s, along x
  float v;      // along y
};

// One side of a face.
struct WaterSide {
  float level;   // m
  float bed;     // m
  float along;   // m/s, through the face
  float across;  // m/s, along it
};

// Through a face, for each m of it.
struct WaterFlux {
  float mass;    // m^2/s
  float before;  // momentum less the hydrostatic pressure of the first side (m^3/s^2)
  float behind;  // and less that of the second
  float across;  // momentum along the face
};

// u = 2 h hu / (h^2 + max(h^2, thin^2)): hu / h where it is not thin (Kurganov and Petrova 2007).
FUNCTION WaterCell waterCell(vec4 texel, float thin) {
  WaterCell c;
  c.level = texel.x;
  precise float depth = texel.x - texel.w;
  depth = max(depth, 0.0f);
  precise float squared = depth * depth;
  precise float least = thin * thin;
  precise float both = squared + max(squared, least);
  precise float factor = 2.0f * depth * exactReciprocal(both);
  precise float u = texel.y * factor;
  precise float v = texel.z * factor;
  c.depth = depth;
  c.u = u;
  c.v = v;
  return c;
}

// As it looks in a wall along y, and in one along x.
FUNCTION WaterCell waterMirrored(WaterCell c, bool alongX, bool alongY) {
  c.u = alongX ? -c.u : c.u;
  c.v = alongY ? -c.v : c.v;
  return c;
}

// The cell that stands for cell i of `count`, -2 <= i <= count + 1. Whether it is mirrored: waterIsMirrored.
FUNCTION int waterFolded(int i, int count, int low, int high) {
  if (i < 0) return low == periodicEdge ? i + count : low == wallEdge ? -1 - i : 0;
  if (i >= count) return high == periodicEdge ? i - count : high == wallEdge ? 2 * count - 1 - i : count - 1;
  return i;
}
FUNCTION bool waterIsMirrored(int i, int count, int low, int high) {
  return (i < 0 && low == wallEdge) || (i >= count && high == wallEdge);
}

// What comes from the sea: a wave that goes one way over still water of the border cell's depth, so u = 2 (c - c0) (a simple
// wave); whatever comes out meets no wall. The level is never below the bed.
FUNCTION WaterCell waterSea(vec4 border, float swell, WaterStep told) {
  precise float top = told.sea + swell;
  precise float level = max(top, border.w);
  precise float depth = level - border.w;
  precise float still = told.sea - border.w;
  precise float weight = told.gravity * depth;
  precise float weight0 = told.gravity * max(still, 0.0f);
  precise float speed = 2.0f * (exactSqrt(weight) - exactSqrt(weight0));
  WaterCell c;
  c.level = level;
  c.depth = depth;
  c.u = swell == 0.0f || still <= told.thin ? 0.0f : speed;
  c.v = 0.0f;
  return c;
}

// Of the differences to both neighbours and their mean: twice the smaller ones or the mean, whichever is
// smallest; zero at extremes (van Leer 1977).
FUNCTION float waterLimited(float before, float here, float behind) {
  precise float a = here - before;
  precise float b = behind - here;
  precise float mean = 0.5f * (a + b);
  precise float twiceA = 2.0f * a;
  precise float twiceB = 2.0f * b;
  float up = min(min(twiceA, twiceB), mean);
  float down = max(max(twiceA, twiceB), mean);
  return a > 0.0f && b > 0.0f ? up : a < 0.0f && b < 0.0f ? down : 0.0f;
}

// Change across `here`; none beside what is dry, where levels are the bed's.
FUNCTION WaterCell waterSlope(WaterCell before, WaterCell here, WaterCell behind, float dry) {
  WaterCell s;
  s.level = waterLimited(before.level, here.level, behind.level);
  s.depth = waterLimited(before.depth, here.depth, behind.depth);
  s.u = waterLimited(before.u, here.u, behind.u);
  s.v = waterLimited(before.v, here.v, behind.v);
  bool wet = before.depth > dry && here.depth > dry && behind.depth > dry;
  s.level = wet ? s.level : 0.0f;
  s.depth = wet ? s.depth : 0.0f;
  s.u = wet ? s.u : 0.0f;
  s.v = wet ? s.v : 0.0f;
  return s;
}

// Half a step of w_t = -(hu)_x - (hv)_y, u_t = -u u_x - v u_y - g w_x and the same for v.
FUNCTION WaterCell waterHalf(WaterCell c, WaterCell sx, WaterCell sy, float halfRatio, float gravity) {
  precise float rise = (c.u * sx.depth + c.depth * sx.u) + (c.v * sy.depth + c.depth * sy.v);
  precise float slowU = (c.u * sx.u + gravity * sx.level) + c.v * sy.u;
  precise float slowV = (c.v * sy.v + gravity * sy.level) + c.u * sx.v;
  precise float level = c.level - halfRatio * rise;
  precise float depth = c.depth - halfRatio * rise;
  precise float u = c.u - halfRatio * slowU;
  precise float v = c.v - halfRatio * slowV;
  WaterCell half_;
  half_.level = level;
  half_.depth = max(depth, 0.0f);
  half_.u = u;
  half_.v = v;
  return half_;
}

// The cell's side at half its slope times `sign`; half_ is the cell half a step later. The bed stays where it is.
FUNCTION WaterSide waterSideX(WaterCell c, WaterCell half_, WaterCell slope, float sign) {
  WaterSide s;
  precise float bed = (c.level + sign * slope.level) - (c.depth + sign * slope.depth);
  precise float level = half_.level + sign * slope.level;
  precise float along = half_.u + sign * slope.u;
  precise float across = half_.v + sign * slope.v;
  s.bed = bed;
  s.level = level;
  s.along = along;
  s.across = across;
  return s;
}
FUNCTION WaterSide waterSideY(WaterCell c, WaterCell half_, WaterCell slope, float sign) {
  WaterSide s = waterSideX(c, half_, slope, sign);
  float along = s.along;
  s.along = s.across;
  s.across = along;
  return s;
}

// HLL with the wave speeds of two rarefactions, between depths over the higher of the two beds. Written so that equal
// levels at rest give zeros. A cell gives away no more than `mostA` or `mostB`, a quarter of what it has, so none
// becomes negative.
FUNCTION WaterFlux waterFlux(WaterSide a, WaterSide b, float gravity, float mostA, float mostB) {
  float bed = max(a.bed, b.bed);
  precise float depthA = a.level - bed;
  precise float depthB = b.level - bed;
  depthA = max(depthA, 0.0f);
  depthB = max(depthB, 0.0f);
  precise float weightA = gravity * depthA;
  precise float weightB = gravity * depthB;
  float waveA = exactSqrt(weightA);
  float waveB = exactSqrt(weightB);
  precise float middle = 0.5f * (a.along + b.along) + (waveA - waveB);
  precise float middleWave = 0.5f * (waveA + waveB) + 0.25f * (a.along - b.along);
  precise float leftA = a.along - waveA;
  precise float leftMiddle = middle - middleWave;
  precise float leftDry = b.along - 2.0f * waveB;
  precise float rightB = b.along + waveB;
  precise float rightMiddle = middle + middleWave;
  precise float rightDry = a.along + 2.0f * waveA;
  float left = depthA > 0.0f ? min(leftA, leftMiddle) : leftDry;
  float right = depthB > 0.0f ? max(rightB, rightMiddle) : rightDry;
  left = depthB > 0.0f ? left : leftA;
  right = depthA > 0.0f ? right : rightB;
  left = min(left, 0.0f);
  right = max(right, 0.0f);
  precise float span = right - left;
  float inverse = exactReciprocal(max(span, 1e-6f));
  precise float product = left * right;
  precise float flowA = depthA * a.along;
  precise float flowB = depthB * b.along;
  precise float rise = depthB - depthA;
  precise float mass = (right * flowA - left * flowB + product * rise) * inverse;
  mass = max(min(mass, mostA), -mostB);
  precise float jump = 0.5f * gravity * rise * (depthA + depthB);
  precise float before = (right * (flowA * a.along) - left * (flowB * b.along + jump) + product * (flowB - flowA)) * inverse;
  precise float behind = before - jump;
  precise float across = mass * (mass > 0.0f ? a.across : b.across);
  WaterFlux f;
  f.mass = mass;
  f.before = before;
  f.behind = behind;
  f.across = across;
  return f;
}

// What is thinner than a picometre is nothing: so no product here is a subnormal number that a sum would show.
FUNCTION float waterFlush(float x) {
  return abs(x) < 1e-12f ? 0.0f : x;
}

// The state from what has come in: friction, which is implicit and so never turns anything round, and what is dry
// stands still. `moved`: level and discharges before that.
FUNCTION vec4 waterSettled(vec3 moved, float bed, WaterStep s) {
  precise float depth = moved.x - bed;
  float level = depth <= 1e-12f ? bed : waterFlush(moved.x);  // what is no number stays so
  precise float qx = moved.y * s.kept;
  precise float qy = moved.z * s.kept;
  if (s.manning > 0.0f) {
    // dq/dt = -g n^2 |q| q / h^(7/3)
    float held = max(depth, s.thin);
    precise float weight = held * held * exactPow(held, 0.33333333f);
    precise float flow2 = qx * qx + qy * qy;
    precise float resisting = s.manning * exactSqrt(flow2);
    precise float whole = weight + resisting;
    precise float left = weight * exactReciprocal(whole);
    qx = qx * left;
    qy = qy * left;
  }
  bool stands = depth <= s.dry;
  return vec4(level, stands ? 0.0f : waterFlush(qx), stands ? 0.0f : waterFlush(qy), bed);
}

// A cell's texel from what goes through its sides. half_ is the cell half a step later, with its slopes.
FUNCTION vec4 waterGathered(vec4 texel, WaterCell half_, WaterCell slopeX, WaterCell slopeY, WaterFlux east, WaterFlux west,
                            WaterFlux south, WaterFlux north, WaterStep told) {
  // Within the cell the pressure changes by g h dw.
  precise float pressX = told.gravity * half_.depth * slopeX.level;
  precise float pressY = told.gravity * half_.depth * slopeY.level;
  precise float out_ = (east.mass - west.mass) + (south.mass - north.mass);
  precise float outX = ((east.before - west.behind) + pressX) + (south.across - north.across);
  precise float outY = ((south.before - north.behind) + pressY) + (east.across - west.across);
  precise float level = texel.x - told.ratio * out_;
  level = level + told.rain;
  precise float qx = texel.y - told.ratio * outX;
  precise float qy = texel.z - told.ratio * outY;
  return waterSettled(vec3(level, qx, qy), texel.w, told);
}

// (|u| + sqrt(g h)) dt / side along the faster of both axes; of what is thin 0.
FUNCTION float waterCourant(WaterCell c, WaterStep s) {
  precise float weight = s.gravity * c.depth;
  precise float fastest = max(abs(c.u), abs(c.v)) + exactSqrt(weight);
  precise float number = fastest * s.ratio;
  return c.depth > s.thin ? number : 0.0f;
}

// What a drop adds to the level of a cell.
FUNCTION float waterDropAt(WaterDrop d, ivec2 cell, vec4 texel) {
  precise float depth = texel.x - texel.w;
  precise float x = float(cell.x) + 0.5f - d.center.x;
  precise float y = float(cell.y) + 0.5f - d.center.y;
  precise float inside = 1.0f - (x * x + y * y) * d.perRadius2;
  inside = max(inside, 0.0f);
  precise float rise = inside * inside * d.height;
  return depth > d.shallow ? rise : 0.0f;
}

// A cell's texel with `rise` (m) more water; never below the bed. What is taken away takes its discharge along.
FUNCTION vec4 waterRaised(vec4 texel, float rise) {
  precise float level = texel.x + rise;
  precise float depth = texel.x - texel.w;
  precise float left = 1.0f + rise * exactReciprocal(max(depth, 1e-12f));
  left = rise < 0.0f ? max(left, 0.0f) : 1.0f;
  precise float qx = texel.y * left;
  precise float qy = texel.z * left;
  return vec4(max(waterFlush(level), texel.w), waterFlush(qx), waterFlush(qy), texel.w);
}

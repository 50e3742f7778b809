// One step of the shallow water equations in one cell, in exact arithmetic. Compiles as GLSL and as C++
// (src/sim/water/plan.hpp), after common/exact.glsl and water/types.glsl.
//
//   h_t + (hu)_x + (hv)_y = rain
//   (hu)_t + (hu^2 + g h^2 / 2)_x + (huv)_y = -g h b_x - friction,    the same for hv,    level w = h + b
//
// Finite volume method (MUSCL-Hancock): limited slopes of level, depth and velocity; half a step in each cell; then HLL
// fluxes between the hydrostatically reconstructed states on both sides of a face (Audusse, Bouchut, Bristeau, Klein
// and Perthame 2004; Toro 2001 for wave speeds). The stored quantity is the level, so for a constant level at rest
// every term is exactly zero, whatever the bed is.

struct WaterCell {
  float level;  // Water level, m
  float depth;  // Depth, m, not negative
  float u;      // Velocity along x, m/s
  float v;      // Velocity along y, m/s
};

// State on one side of a face.
struct WaterSide {
  float level;   // Level in metres
  float bed;     // Height of the bed in metres
  float along;   // Velocity normal to the face, m/s
  float across;  // Velocity tangential to the face, m/s
};

// Flux through a face, per metre of its length.
struct WaterFlux {
  float mass;    // Volume flux, m^2/s
  float before;  // Normal momentum minus the hydrostatic pressure of the first side, m^3/s^2
  float behind;  // Normal momentum minus the hydrostatic pressure of the second side, m^3/s^2
  float across;  // Tangential momentum, m^3/s^2
};

// Returns a cell's state. Its velocity is u = 2 h hu / (h^2 + max(h^2, thin^2)), where h is the depth and hu the
// discharge; it equals hu / h unless the water is thin (Kurganov and Petrova 2007).
FUNCTION WaterCell waterCell(vec4 texel, float thin) {
  WaterCell c;
  c.level = texel.x;
  precise float depth = texel.x - texel.w;
  depth = max(depth, 0.0f);
  precise float squared = depth * depth;
  precise float minimum = thin * thin;
  precise float both = squared + max(squared, minimum);
  precise float factor = 2.0f * depth * exactReciprocal(both);
  precise float u = texel.y * factor;
  precise float v = texel.z * factor;
  c.depth = depth;
  c.u = u;
  c.v = v;
  return c;
}

// Returns the mirror image of a cell: u is reversed if `alongX` is true, v if `alongY` is true.
FUNCTION WaterCell waterMirrored(WaterCell c, bool alongX, bool alongY) {
  c.u = alongX ? -c.u : c.u;
  c.v = alongY ? -c.v : c.v;
  return c;
}

// Returns the index of the cell that stands for the index i of `count`, where -2 <= i <= count + 1. waterIsMirrored()
// returns true if its mirror image must be used.
FUNCTION int waterFolded(int i, int count, int low, int high) {
  if (i < 0) return low == periodicEdge ? i + count : low == wallEdge ? -1 - i : 0;
  if (i >= count) return high == periodicEdge ? i - count : high == wallEdge ? 2 * count - 1 - i : count - 1;
  return i;
}
FUNCTION bool waterIsMirrored(int i, int count, int low, int high) {
  return (i < 0 && low == wallEdge) || (i >= count && high == wallEdge);
}

// Returns the state beyond a side that is a sea: a wave that enters over still water of the border cell's depth, with u
// = 2 (c - c0), where c and c0 are the wave speeds with and without the wave (simple wave). Outgoing waves are not
// reflected. The level is never below the bed.
FUNCTION WaterCell waterSea(vec4 border, float swell, WaterStep uniforms) {
  precise float top = uniforms.sea + swell;
  precise float level = max(top, border.w);
  precise float depth = level - border.w;
  precise float still = uniforms.sea - border.w;
  precise float weight = uniforms.gravity * depth;
  precise float weight0 = uniforms.gravity * max(still, 0.0f);
  precise float speed = 2.0f * (exactSqrt(weight) - exactSqrt(weight0));
  WaterCell c;
  c.level = level;
  c.depth = depth;
  c.u = swell == 0.0f || still <= uniforms.thin ? 0.0f : speed;
  c.v = 0.0f;
  return c;
}

// Returns the limited difference across a cell: the one with the minimum magnitude among twice each one-sided
// difference and the mean of both; 0 at an extremum (van Leer 1977).
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

// Returns the limited differences across a cell. They are 0 next to dry cells, where the level equals the bed.
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

// Advances a cell by half a step of w_t = -(hu)_x - (hv)_y and u_t = -u u_x - v u_y - g w_x, and likewise for v, where
// w is the level.
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

// Returns the cell's state at one of its sides, offset from the centre by half the slope times `sign`. half_ is the
// cell half a step later. The bed does not change.
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

// Returns the HLL flux with the wave speeds of the two-rarefaction approximation, for the depths above the higher of
// the two beds. It is exactly zero if the levels are equal and the water is at rest. The two cells give away at most
// `maxA` and `maxB`, a quarter of their water, so that no depth becomes negative.
FUNCTION WaterFlux waterFlux(WaterSide a, WaterSide b, float gravity, float maxA, float maxB) {
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
  mass = max(min(mass, maxA), -maxB);
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

// Returns x, or 0 if its magnitude is below 1e-12, so that no product becomes a subnormal number.
FUNCTION float waterFlush(float x) {
  return abs(x) < 1e-12f ? 0.0f : x;
}

// Completes a state: applies friction, integrated implicitly so that it never reverses the flow, and stops dry cells.
// `moved` holds the level and the discharges before friction.
FUNCTION vec4 waterSettled(vec3 moved, float bed, WaterStep s) {
  precise float depth = moved.x - bed;
  float level = depth <= 1e-12f ? bed : waterFlush(moved.x);  // A NaN level is kept, so that later checks find it.
  precise float qx = moved.y * s.kept;
  precise float qy = moved.z * s.kept;
  if (s.manning > 0.0f) {
    // Friction is dq/dt = -g n^2 |q| q / h^(7/3), with the discharge q and Manning's n.
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

// Returns a cell's new texel from the fluxes through its sides. half_ is the cell half a step later; slopeX and slopeY
// are the cell's slopes.
FUNCTION vec4 waterGathered(vec4 texel, WaterCell half_, WaterCell slopeX, WaterCell slopeY, WaterFlux east, WaterFlux west,
                            WaterFlux south, WaterFlux north, WaterStep uniforms) {
  // Adds the pressure change inside the cell, g h dw, where dw is the change of the level.
  precise float pressX = uniforms.gravity * half_.depth * slopeX.level;
  precise float pressY = uniforms.gravity * half_.depth * slopeY.level;
  precise float out_ = (east.mass - west.mass) + (south.mass - north.mass);
  precise float outX = ((east.before - west.behind) + pressX) + (south.across - north.across);
  precise float outY = ((south.before - north.behind) + pressY) + (east.across - west.across);
  precise float level = texel.x - uniforms.ratio * out_;
  level = level + uniforms.rain;
  precise float qx = texel.y - uniforms.ratio * outX;
  precise float qy = texel.z - uniforms.ratio * outY;
  return waterSettled(vec3(level, qx, qy), texel.w, uniforms);
}

// Returns the Courant number (|u| + sqrt(g h)) dt / cell size along the axis where it is larger; 0 for thin water.
FUNCTION float waterCourant(WaterCell c, WaterStep s) {
  precise float weight = s.gravity * c.depth;
  precise float fastest = max(abs(c.u), abs(c.v)) + exactSqrt(weight);
  precise float number = fastest * s.ratio;
  return c.depth > s.thin ? number : 0.0f;
}

// Returns the rise of a cell's level by a drop, in metres.
FUNCTION float waterDropAt(WaterDrop d, ivec2 cell, vec4 texel) {
  precise float depth = texel.x - texel.w;
  precise float x = float(cell.x) + 0.5f - d.center.x;
  precise float y = float(cell.y) + 0.5f - d.center.y;
  precise float inside = 1.0f - (x * x + y * y) * d.perRadius2;
  inside = max(inside, 0.0f);
  precise float rise = inside * inside * d.height;
  return depth > d.shallow ? rise : 0.0f;
}

// Returns a cell's texel with `rise` metres more water, where the level is at least the bed. Removed water takes its
// discharge with it.
FUNCTION vec4 waterRaised(vec4 texel, float rise) {
  precise float level = texel.x + rise;
  precise float depth = texel.x - texel.w;
  precise float left = 1.0f + rise * exactReciprocal(max(depth, 1e-12f));
  left = rise < 0.0f ? max(left, 0.0f) : 1.0f;
  precise float qx = texel.y * left;
  precise float qy = texel.z * left;
  return vec4(max(waterFlush(level), texel.w), waterFlush(qx), waterFlush(qy), texel.w);
}

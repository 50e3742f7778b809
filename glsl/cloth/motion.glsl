// Motion of a particle of any cloth through pins, colliders, ground and walls. Compiles as GLSL and as C++. Needs
// `stepData` (ClothStep), everything that collide/field_model.glsl needs, mesh/height_model.glsl and
// contour/wall_model.glsl.
FUNCTION float applyRow(vec4 row, vec3 p) {
  precise float value = exactDot(vec3(row), p) + row.w;
  return value;
}

#include "collide/model.glsl"

// Moves the particle out of all colliders. If `lands` is true, also tests the colliding mesh. If `walled` is true, also
// tests the solid's walls, as the last step, along the path from `before`.
FUNCTION Motion contact(Motion m, vec3 before, bool lands, bool walled) {
  m = outOfShapes(m, before, stepData.constants.margin, 0.0f);
  m = outOfMeshes(m, before, stepData.constants.margin, 0.0f);
  if (lands) {
    Landing l = landed(m.position, m.velocity);
    m.position = l.position;
    m.velocity = l.velocity;
  }
  if (walled) {
    WallMotion w = outOfWalls(before, m.position, m.velocity);
    m.position = w.position;
    m.velocity = w.velocity;
  }
  return m;
}

// The velocity change by constraints follows a second-order difference formula (BDF2); forces do not use it. x_n, v_n
// and a_n are position, velocity and acceleration by forces at substep n. The trend of the previous substep is p = v_n
// - v_n-1 - dt a_n-1; u = v_n + dt a_n is the velocity after forces alone (semi-implicit Euler, as without
// constraints); h = 2/3 dt. Then
//   x_led = x_n + dt u + dt p / 18,   x' = x_led + s,   p' = p / 3 + s / h,   v' = u + p',
// where s is the displacement by constraints of compliance / h^2. A swing of w rad/s loses a fraction (w dt)^4 / 3 of
// its energy per substep; the first-order formula (p = 0, h = dt) would lose (w dt)^2. A straight line under tension,
// with the constraints linearized at x_led, swings sideways without growth if w dt < 1.65 (first order: 1.15), where
// w^2 <= 4 T / (m L). One-sided corrections (contact, attachments) are not part of the trend, because the trend would
// make them bounce. The code adds s / h to a velocity, because (x' - x_n) / dt would lose accelerations below the
// rounding of x / dt^2.
FUNCTION vec3 ledTo(vec3 before, vec3 aim, vec3 trend) {
  precise vec3 place = before + aim * stepData.dt + trend * stepData.trendDt;
  return place;
}

struct Settled {
  Motion motion;
  vec3 trend;
};

// Completes a particle after the constraints: computes its velocity and trend, then applies contact. `aim` is the
// velocity u after forces alone.
FUNCTION Settled settled(vec4 before, vec4 here, vec3 aim, vec3 trend, bool lands, bool walled) {
  Settled s;
  s.motion.position = vec3(here);
  s.motion.velocity = vec3(0.0f);
  s.trend = trend;
  if (here.w == 0.0f) return s;
  vec3 led = ledTo(vec3(before), aim, trend);
  precise vec3 next = trend * 0.33333333f + (vec3(here) - led) * stepData.perReach;
  // The trend is flushed to zero, because it falls to a third per substep if no constraint acts, and some GPUs would
  // compute with subnormal numbers.
  s.trend = vec3(exactFlush(next.x), exactFlush(next.y), exactFlush(next.z));
  precise vec3 velocity = aim + s.trend;
  s.motion.velocity = velocity;
  s.motion = contact(s.motion, vec3(before), lands, walled);
  return s;
}

// Moves a particle of energy-conserving cloth by its velocity, starting at `before`, then applies contact. A pinned
// particle moves to `here`. The velocity is not recomputed from the rounded positions, because that would add energy to
// the cloth.
FUNCTION Motion forced(vec4 before, vec4 here, vec3 velocity, bool lands, bool walled) {
  Motion m;
  precise vec3 moved = vec3(before) + velocity * stepData.dt;
  m.position = moved;
  m.velocity = velocity;
  if (here.w > 0.0f) return contact(m, vec3(before), lands, walled);
  m.position = vec3(here);
  return m;
}

// Corrects the velocity after contact between cloths has pushed the particle from `left` to `here`, then applies
// contact with colliders. Does nothing if the particle was not pushed.
FUNCTION Motion settledAgain(vec4 before, vec4 left, vec4 here, vec3 velocity, bool lands, bool walled) {
  Motion m;
  m.position = vec3(here);
  m.velocity = velocity;
  precise vec3 pushed = vec3(here) - vec3(left);
  bool still = pushed.x == 0.0f && pushed.y == 0.0f && pushed.z == 0.0f;
  if (here.w == 0.0f || still) return m;
  precise vec3 v = velocity + pushed * stepData.perDt;
  m.velocity = v;
  return contact(m, vec3(before), lands, walled);
}

// Returns true if the squared position or the squared speed exceeds 1e10 or is NaN. Compared as an integer, NaN also
// exceeds the limit.
FUNCTION bool isLost(Motion m) {
  int distance = floatBitsToInt(exactDot(m.position, m.position)) & 0x7fffffff;
  int speed = floatBitsToInt(exactDot(m.velocity, m.velocity)) & 0x7fffffff;
  return max(distance, speed) > 0x501502f9;
}

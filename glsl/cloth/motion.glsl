// A particle of any cloth and what it meets: pins, colliders, ground, walls. Compiles as GLSL and as C++; needs `stepData`
// (ClothStep), what collide/field_model.glsl does, mesh/height_model.glsl and contour/wall_model.glsl.
FUNCTION float applyRow(vec4 row, vec3 p) {
  precise float value = exactDot(vec3(row), p) + row.w;
  return value;
}

#include "collide/model.glsl"

// Out of every collider, with `lands` onto the mesh that collides, and with `walled` at last out of the solid that it
// meets, on the way from `before`.
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

// What constraints do to a velocity from substep to substep is a difference formula of second order (BDF2) for them alone: with
// the trend p = v_n - v_n-1 - dt a_n-1 of the substep before, the velocity u = v_n + dt a_n that forces alone would lead to
// (semi-implicit Euler, as without constraints), and h = 2/3 dt,
//   x_led = x_n + dt u + dt p / 18,   x' = x_led + s,   p' = p / 3 + s / h,   v' = u + p',
// where s is what constraints of compliance / h^2 shift. A swing of w rad/s loses (w dt)^4 / 3 of its energy a substep; of first
// order, p = 0 and h = dt, it would be (w dt)^2. Pulling along where the links are at x_led, a straight line under tension
// swings sideways without growing while w dt < 1.65 (1.15 of first order; w^2 = 4 T / (m L) at most). What pushes one way
// only, contact or what pulls things taut, is no part of the trend, which would make it bounce.
// s / h is added to a velocity: (x' - x_n) / dt would lose accelerations below the rounding of x / dt^2.
FUNCTION vec3 ledTo(vec3 before, vec3 aim, vec3 trend) {
  precise vec3 place = before + aim * stepData.dt + trend * stepData.trendDt;
  return place;
}

struct Settled {
  Motion motion;
  vec3 trend;
};

// After the constraints, then contact. `aim`: u.
FUNCTION Settled settled(vec4 before, vec4 here, vec3 aim, vec3 trend, bool lands, bool walled) {
  Settled s;
  s.motion.position = vec3(here);
  s.motion.velocity = vec3(0.0f);
  s.trend = trend;
  if (here.w == 0.0f) return s;
  vec3 led = ledTo(vec3(before), aim, trend);
  precise vec3 next = trend * 0.33333333f + (vec3(here) - led) * stepData.perReach;
  // It falls to a third a substep where nothing pulls, which some GPUs would follow below the smallest normal number.
  s.trend = vec3(exactFlush(next.x), exactFlush(next.y), exactFlush(next.z));
  precise vec3 velocity = aim + s.trend;
  s.motion.velocity = velocity;
  s.motion = contact(s.motion, vec3(before), lands, walled);
  return s;
}

// After forces alone, of cloth that keeps energy: from `before`, unless it is pinned `here`. What a constraint changed a velocity
// by is added to it, for roundings of positions by a substep would heat the cloth.
FUNCTION Motion forced(vec4 before, vec4 here, vec3 velocity, bool lands, bool walled) {
  Motion m;
  precise vec3 moved = vec3(before) + velocity * stepData.dt;
  m.position = moved;
  m.velocity = velocity;
  if (here.w > 0.0f) return contact(m, vec3(before), lands, walled);
  m.position = vec3(here);
  return m;
}

// After cloths in contact pushed a particle from where it was left, if they did.
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

// A position or speed no cloth should have: its square beyond 1e10, or not a number, which as bits is beyond that, too.
FUNCTION bool isLost(Motion m) {
  int distance = floatBitsToInt(exactDot(m.position, m.position)) & 0x7fffffff;
  int speed = floatBitsToInt(exactDot(m.velocity, m.velocity)) & 0x7fffffff;
  return max(distance, speed) > 0x501502f9;
}

// A particle of any cloth and what it meets: pins, colliders, ground, walls. Compiles as GLSL and as C++; needs `stepData`
// (ClothStep), mesh/height_model.glsl and contour/wall_model.glsl.
FUNCTION float applyRow(vec4 row, vec3 p) {
  precise float value = exactDot(vec3(row), p) + row.w;
  return value;
}

struct Motion {
  vec3 position;
  vec3 velocity;
};

// What friction of at most `most` leaves of a sliding: 1 - most / |slide|, and none where that is less.
FUNCTION float leftByFriction(vec3 slide, float most) {
  precise float part = most * exactInverseSqrt(max(exactDot(slide, slide), 1e-24f));
  precise float left = 1.0f - min(part, 1.0f);
  return left;
}

// Out of a collider along its normal; relative to the collider the inward velocity goes. Of the tangential one a fraction
// stays; or Coulomb's law takes as much as the coefficient times what is taken along the normal, of the way since `before`
// too, so that what is held does not creep.
FUNCTION Motion outOf(int i, Motion m, vec3 before) {
  vec3 a = vec3(stepData.colliders[i].a);
  vec3 b = vec3(stepData.colliders[i].b);
  bool plane = stepData.colliders[i].plane == 1;
  precise vec3 axis = b - a;
  precise vec3 fromA = m.position - a;
  precise float t = exactDot(fromA, axis) * stepData.colliders[i].perLengthSquared;
  t = min(max(t, 0.0f), 1.0f);
  precise vec3 offset = m.position - (a + axis * t);
  float squared = exactDot(offset, offset);
  float inverse = exactInverseSqrt(max(squared, 1e-12f));
  precise vec3 normal = plane ? a : offset * inverse;
  precise float beyond = plane ? exactDot(a, m.position) : squared * inverse;
  precise float depth = stepData.colliders[i].reach + stepData.constants.margin - beyond;
  bool touching = depth > 0.0f;
  vec3 velocityA = vec3(stepData.colliders[i].velocityA);
  vec3 velocityB = vec3(stepData.colliders[i].velocityB);
  precise vec3 surface = plane ? vec3(0.0f) : velocityA + (velocityB - velocityA) * t;
  precise vec3 relative = m.velocity - surface;
  float inward = exactDot(relative, normal);
  float friction = stepData.colliders[i].friction;
  bool rubs = friction >= 0.0f;
  precise vec3 sliding = relative - normal * inward;
  precise float mostSpeed = friction * max(-inward, 0.0f);
  float stays = rubs ? leftByFriction(sliding, mostSpeed) : stepData.colliders[i].grip;
  precise vec3 kept = sliding * stays + normal * max(inward, 0.0f) + surface;
  precise vec3 way = m.position - before - surface * stepData.dt;
  float through = exactDot(way, normal);
  precise vec3 slid = way - normal * through;
  precise float mostWay = friction * max(depth, 0.0f);
  float slides = rubs ? leftByFriction(slid, mostWay) : 1.0f;
  precise float held = 1.0f - slides;
  precise vec3 pushed = m.position + normal * depth - slid * held;
  m.position = touching ? pushed : m.position;
  m.velocity = touching ? kept : m.velocity;
  return m;
}

// Out of every collider, with `lands` onto the mesh that collides, and with `walled` at last out of the solid that it
// meets, on the way from `before`.
FUNCTION Motion contact(Motion m, vec3 before, bool lands, bool walled) {
#ifdef COLLIDERS
#define TIMES COLLIDERS
#define REPEATED(i) m = outOf(i, m, before);
#include "common/repeat.glsl"
#else
  for (int i = 0; i < stepData.colliderCount; ++i) m = outOf(i, m, before);
#endif
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

// After the constraints: v = (x - x_before) / dt, then contact.
FUNCTION Motion settled(vec4 before, vec4 here, bool lands, bool walled) {
  Motion m;
  m.position = vec3(here);
  precise vec3 v = (vec3(here) - vec3(before)) * stepData.perDt;
  m.velocity = v;
  if (here.w == 0.0f) {
    m.velocity = vec3(0.0f);
    return m;
  }
  return contact(m, vec3(before), lands, walled);
}

// A position or speed no cloth should have.
FUNCTION bool isLost(Motion m) {
  float distanceSquared = exactDot(m.position, m.position);
  float speedSquared = exactDot(m.velocity, m.velocity);
  bool numbers = isNumber(distanceSquared) && isNumber(speedSquared);
  return !numbers || distanceSquared > 1e10f || speedSquared > 1e10f;
}

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

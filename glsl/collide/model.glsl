// What moves and the shapes that it meets. Compiles as GLSL and as C++; needs `stepData`, a step with `colliders`,
// `colliderCount` and `dt`, and common/exact.glsl.
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

// How something solid takes what touches it.
struct Touch {
  float depth;     // m to its surface and the margin over it; none below 0
  vec3 normal;     // outwards, unit
  vec3 surface;    // m/s
  float grip;      // fraction of tangential velocity kept
  float friction;  // Coulomb's coefficient; below 0: grip
  float bounce;    // fraction of the speed of impact that is given back
};

// Out along the normal; relative to the surface the inward velocity goes, or turns round by the share that is given back.
// Of the tangential one a fraction stays; or Coulomb's law takes at most the coefficient times the change along the normal,
// mu (1 + e) |v_n| of an impact, of the way since `before` too, so that what is held does not creep.
FUNCTION Motion pushedOut(Motion m, vec3 before, Touch touch) {
  bool touching = touch.depth > 0.0f;
  vec3 normal = touch.normal, surface = touch.surface;
  precise vec3 relative = m.velocity - surface;
  float inward = exactDot(relative, normal);
  float friction = touch.friction;
  bool rubs = friction >= 0.0f;
  precise vec3 sliding = relative - normal * inward;
  precise float back = inward * -touch.bounce;
  float outward = max(inward, back);
  precise float mostSpeed = friction * (outward - inward);
  float stays = rubs ? leftByFriction(sliding, mostSpeed) : touch.grip;
  precise vec3 kept = sliding * stays + normal * outward + surface;
  precise vec3 way = m.position - before - surface * stepData.dt;
  float through = exactDot(way, normal);
  precise vec3 slid = way - normal * through;
  precise float mostWay = friction * max(touch.depth, 0.0f);
  float slides = rubs ? leftByFriction(slid, mostWay) : 1.0f;
  precise float held = 1.0f - slides;
  precise vec3 pushed = m.position + normal * touch.depth - slid * held;
  m.position = touching ? pushed : m.position;
  m.velocity = touching ? kept : m.velocity;
  return m;
}

// Out of collider i, with `margin` over it.
FUNCTION Motion outOf(int i, Motion m, vec3 before, float margin, float bounce) {
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
  precise float depth = stepData.colliders[i].reach + margin - beyond;
  vec3 velocityA = vec3(stepData.colliders[i].velocityA);
  vec3 velocityB = vec3(stepData.colliders[i].velocityB);
  precise vec3 surface = plane ? vec3(0.0f) : velocityA + (velocityB - velocityA) * t;
  Touch touch;
  touch.depth = depth;
  touch.normal = normal;
  touch.surface = surface;
  touch.grip = stepData.colliders[i].grip;
  touch.friction = stepData.colliders[i].friction;
  touch.bounce = bounce;
  return pushedOut(m, before, touch);
}

// Out of every shape in turn. Kernels of software drivers know how many there are (COLLIDERS).
FUNCTION Motion outOfShapes(Motion m, vec3 before, float margin, float bounce) {
#ifdef COLLIDERS
#define TIMES COLLIDERS
#define REPEATED(i) m = outOf(i, m, before, margin, bounce);
#include "common/repeat.glsl"
#else
  for (int i = 0; i < stepData.colliderCount; ++i) m = outOf(i, m, before, margin, bounce);
#endif
  return m;
}

#if defined MESHES && !MESHES
FUNCTION Motion outOfMeshes(Motion m, vec3 before, float margin, float bounce) {
  return m;
}
#else
#include "collide/field_model.glsl"

// Out of every rigid mesh in turn; for software drivers the place in the uniform block is a constant (common/repeat.glsl).
FUNCTION Motion outOfMeshes(Motion m, vec3 before, float margin, float bounce) {
#ifdef COLLIDERS
#define AND_MESH(k) m = outOfMesh(k, m, before, margin, bounce);
  AND_MESH(0)
#if MESHES > 1
  AND_MESH(1)
#endif
#if MESHES > 2
  AND_MESH(2)
#endif
#if MESHES > 3
  AND_MESH(3)
#endif
#if MESHES > 4
  AND_MESH(4)
#endif
#if MESHES > 5
  AND_MESH(5)
#endif
#if MESHES > 6
  AND_MESH(6)
#endif
#if MESHES > 7
  AND_MESH(7)
#endif
#else
  for (int i = 0; i < meshData.count; ++i) m = outOfMesh(i, m, before, margin, bounce);
#endif
  return m;
}
#endif

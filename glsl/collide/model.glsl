// Motion of a particle and its contact with shapes. Compiles as GLSL and as C++. Needs common/exact.glsl and
// `stepData`, a struct with `colliders`, `colliderCount` and `dt`.
// If ROLLS is defined and stepData.balls.rolls is 1, the particle is a ball that turns.
struct Motion {
  vec3 position;
  vec3 velocity;
#ifdef ROLLS
  vec3 spin;  // Angular velocity times radius, m/s
  vec3 roll;  // Angle turned in the substep times radius, m
#endif
};

#include "collide/friction.glsl"
#ifdef ROLLS
#include "collide/rolling.glsl"
#endif

// Contact with a surface.
struct Touch {
  float depth;     // Depth below the surface plus margin, m; there is no contact unless it is positive
  vec3 normal;     // Outward unit normal
  vec3 surface;    // Velocity of the surface, m/s
  float grip;      // Fraction of the tangential velocity that remains
  float friction;  // Coulomb friction coefficient; if negative, `grip` applies instead
  float bounce;    // Fraction e of the impact speed that remains after the bounce
};

// Moves the particle out along the normal. Relative to the surface, the inward velocity v_n becomes zero, or is
// reversed and multiplied by the fraction e (`bounce`). The tangential velocity is either multiplied by `grip`, or
// reduced by Coulomb's law by at most mu (1 + e) |v_n|, which is the friction coefficient mu times the change along the
// normal. Coulomb friction also acts on the displacement since `before`, so that a particle at rest does not creep.
FUNCTION Motion pushedOut(Motion m, vec3 before, Touch touch) {
  bool touching = touch.depth > 0.0f;
  vec3 normal = touch.normal, surface = touch.surface;
  precise vec3 relative = m.velocity - surface;
  float inward = exactDot(relative, normal);
#ifdef ROLLS
  bool rolls = stepData.balls.rolls != 0;
#endif
  float friction = touch.friction;
  bool rubs = friction >= 0.0f;
  precise vec3 sliding = relative - normal * inward;
  precise float back = inward * -touch.bounce;
  float outward = max(inward, back);
  precise float maxSpeed = friction * (outward - inward);
#ifdef ROLLS
  vec3 slip = rolls ? rollingSlip(sliding, m.spin, normal) : sliding;
#else
  vec3 slip = sliding;
#endif
  float stays = rubs ? leftByFriction(slip, maxSpeed) : touch.grip;
  precise vec3 kept = sliding * stays + normal * outward + surface;
  precise vec3 way = m.position - before - surface * stepData.dt;
  float through = exactDot(way, normal);
  precise vec3 slid = way - normal * through;
  precise float maxWay = friction * max(touch.depth, 0.0f);
#ifdef ROLLS
  if (rolls) slid = rollingSlip(slid, m.roll, normal);
#endif
  float slides = rubs ? leftByFriction(slid, maxWay) : 1.0f;
  precise float held = 1.0f - slides;
  precise vec3 pushed = m.position + normal * touch.depth - slid * held;
#ifdef ROLLS
  if (rolls && touching) {
    precise float lost = 1.0f - stays;
    precise vec3 rubbed = slip * lost;
    kept = sliding + normal * outward + surface - rubbed;
    precise vec3 undone = slid * held;
    m.spin = rolledBy(m.spin, normal, rubbed);
    m.roll = rolledBy(m.roll, normal, undone);
  }
#endif
  m.position = touching ? pushed : m.position;
  m.velocity = touching ? kept : m.velocity;
  return m;
}

// Moves the particle out of collider i, to the distance `margin`.
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

// Moves the particle out of all shapes, one after another. Kernels for software drivers have the number of shapes as a
// constant (COLLIDERS).
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

// Moves the particle out of all rigid meshes, one after another. For software drivers, the index into the uniform block
// is a constant (common/repeat.glsl).
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

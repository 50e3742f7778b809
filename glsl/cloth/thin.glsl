// Contact of cloth edges and faces with thin spheres and capsules, which would pass between vertices because they are
// thinner than the cloth's spacing. Compiles as GLSL and as C++. Needs `stepData` (ClothStep), cloth/motion.glsl and
// collide/closest.glsl.
//
// For each edge and face around a vertex, the closest points of cloth and collider at the start of the substep define a
// normal. The collider cannot have passed through yet, so the normal has the right sign. At the end of the substep, the
// two points must be apart by radius + margin along the normal, however far they moved. If they are not, the cloth
// point is pushed out like a vertex. To move a cloth point with the barycentric weights w, corner j is displaced by w_j
// W_j / sum w^2 W, where W is the corner's inverse mass. For each collider, a vertex uses its largest displacement. All
// vertices move simultaneously, so the order does not matter. The test runs thinRounds times, to resolve the remaining
// overlap.
#include "cloth/thin_rounds.glsl"

struct Corner {
  vec3 before;
  vec3 now;
  vec3 velocity;
  float inverseMass;
};

struct ThinPush {
  vec3 shift;    // Displacement in metres
  vec3 change;   // Change of the velocity in m/s
  float squared; // Squared length of `shift`
};

FUNCTION Corner cornerOf(vec4 before, vec4 now, vec4 velocity) {
  Corner corner;
  corner.before = vec3(before);
  corner.now = vec3(now);
  corner.velocity = vec3(velocity);
  corner.inverseMass = before.w;
  return corner;
}

FUNCTION vec3 sharedBy(vec3 shares, vec3 a, vec3 b, vec3 c) {
  precise vec3 sum = a * shares.x + b * shares.y + c * shares.z;
  return sum;
}

// Tests collider i, at the parameter t along its axis, against the cloth point with the weights `shares` of the corners
// a, b and c. Returns the larger of `maximum` and the resulting displacement of corner a.
FUNCTION ThinPush pushedAt(ThinPush maximum, int i, float t, vec3 shares, Corner a, Corner b, Corner c) {
  vec3 velocityA = vec3(stepData.colliders[i].velocityA);
  vec3 velocityB = vec3(stepData.colliders[i].velocityB);
  precise vec3 surface = velocityA + (velocityB - velocityA) * t;
  precise vec3 there = vec3(stepData.colliders[i].a) + (vec3(stepData.colliders[i].b) - vec3(stepData.colliders[i].a)) * t;
  precise vec3 wasThere = there - surface * stepData.dt;
  vec3 before = sharedBy(shares, a.before, b.before, c.before);
  Motion m;
  m.position = sharedBy(shares, a.now, b.now, c.now);
  m.velocity = sharedBy(shares, a.velocity, b.velocity, c.velocity);
  precise vec3 offset = before - wasThere;
  float squared = exactDot(offset, offset);
  precise vec3 normal = offset * exactInverseSqrt(max(squared, 1e-12f));
  precise vec3 separation = m.position - there;
  precise float depth = stepData.colliders[i].reach + stepData.constants.margin - exactDot(separation, normal);
  Touch touch;
  touch.depth = squared > 1e-12f ? depth : 0.0f;
  touch.normal = normal;
  touch.surface = surface;
  touch.grip = stepData.colliders[i].grip;
  touch.friction = stepData.colliders[i].friction;
  touch.bounce = 0.0f;
  Motion out_ = pushedOut(m, before, touch);
  precise float weight = shares.x * shares.x * a.inverseMass + shares.y * shares.y * b.inverseMass +
                         shares.z * shares.z * c.inverseMass;
  precise float part = shares.x * a.inverseMass * exactReciprocal(max(weight, 1e-20f));
  precise vec3 shift = (out_.position - m.position) * part;
  precise vec3 change = (out_.velocity - m.velocity) * part;
  float size = exactDot(shift, shift);
  if (touch.depth > 0.0f && size > maximum.squared) {
    maximum.shift = shift;
    maximum.change = change;
    maximum.squared = size;
  }
  return maximum;
}

FUNCTION ThinPush pushedByEdge(ThinPush maximum, int i, Corner a, Corner b) {
  precise vec3 start = vec3(stepData.colliders[i].a) - vec3(stepData.colliders[i].velocityA) * stepData.dt;
  precise vec3 end = vec3(stepData.colliders[i].b) - vec3(stepData.colliders[i].velocityB) * stepData.dt;
  Crossing crossing = crossingOf(a.before, b.before, start, end, stepData.colliders[i].perLengthSquared);
  precise float rest = 1.0f - crossing.onFirst;
  return pushedAt(maximum, i, crossing.onSecond, vec3(rest, crossing.onFirst, 0.0f), a, b, b);
}

// Tests a face against both ends of a capsule, or against the centre of a sphere.
FUNCTION ThinPush pushedByFace(ThinPush maximum, int i, Corner a, Corner b, Corner c) {
  precise vec3 start = vec3(stepData.colliders[i].a) - vec3(stepData.colliders[i].velocityA) * stepData.dt;
  precise vec3 end = vec3(stepData.colliders[i].b) - vec3(stepData.colliders[i].velocityB) * stepData.dt;
  Closest first = closestOf(start, a.before, b.before, c.before);
  precise float restOfFirst = 1.0f - first.v - first.w;
  maximum = pushedAt(maximum, i, 0.0f, vec3(restOfFirst, first.v, first.w), a, b, c);
  if (stepData.colliders[i].perLengthSquared > 0.0f) {
    Closest last = closestOf(end, a.before, b.before, c.before);
    precise float restOfLast = 1.0f - last.v - last.w;
    maximum = pushedAt(maximum, i, 1.0f, vec3(restOfLast, last.v, last.w), a, b, c);
  }
  return maximum;
}

// Returns true if collider i may touch the faces around the vertex. They are tested up to the distance of the
// collider's radius, plus the motion of both in the substep, plus the side length of the faces.
FUNCTION bool mayMeet(int i, Corner a) {
  vec3 from = vec3(stepData.colliders[i].a);
  precise vec3 axis = vec3(stepData.colliders[i].b) - from;
  precise vec3 fromA = a.now - from;
  precise float along = exactDot(fromA, axis) * stepData.colliders[i].perLengthSquared;
  precise vec3 separation = fromA - axis * clamp(along, 0.0f, 1.0f);
  precise vec3 way = a.now - a.before;
  float waySquared = exactDot(way, way);
  vec3 velocityA = vec3(stepData.colliders[i].velocityA), velocityB = vec3(stepData.colliders[i].velocityB);
  float fastest = max(exactDot(velocityA, velocityA), exactDot(velocityB, velocityB));
  precise float reach = stepData.colliders[i].reach + stepData.constants.margin + stepData.thinRoom +
                        exactSqrt(waySquared) * 2.0f + exactSqrt(fastest) * stepData.dt;
  precise float maximum = reach * reach;
  return exactDot(separation, separation) < maximum;
}

FUNCTION ThinPush notPushed() {
  ThinPush none;
  none.shift = vec3(0.0f);
  none.change = vec3(0.0f);
  none.squared = 0.0f;
  return none;
}

FUNCTION ThinPush together(ThinPush sum, ThinPush more) {
  precise vec3 shift = sum.shift + more.shift;
  precise vec3 change = sum.change + more.change;
  sum.shift = shift;
  sum.change = change;
  return sum;
}

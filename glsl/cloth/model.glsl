// One particle of the mass-spring cloth over one substep. Compiles as GLSL and as C++, where it is the
// CPU twin. Whoever includes it provides `size` (ivec2), `stepData` (ClothStep), loadPosition(int),
// and the files types.glsl, common/exact.glsl, common/hash.glsl, mesh/height_model.glsl, contour/wall_model.glsl before it.

FUNCTION int neighbour(ivec2 at, int dx, int dy) {
  // A neighbour beyond the border becomes the particle itself: its springs then have no length and no force.
  int x = at.x + dx;
  int y = at.y + dy;
  bool inside = x >= 0 && y >= 0 && x < size.x && y < size.y;
  return inside ? y * size.x + x : at.y * size.x + at.x;
}

// Of the springs of a kind: 0 structural, 1 shear, 2 bend.
FUNCTION float springLength(int kind) {
  float ratio = kind == 0 ? 1.0f : kind == 1 ? 1.41421356f : 2.0f;
  precise float restLength = stepData.constants.spacing * ratio;
  return restLength;
}
// compliance / dt^2
FUNCTION float scaledCompliance(int kind) {
  float compliance = kind == 0   ? stepData.constants.compliance
                     : kind == 1 ? stepData.constants.shearCompliance
                                 : stepData.constants.bendCompliance;
  precise float scaled = compliance * stepData.perDtSquared;
  return scaled;
}
// Of a fabric's row, or column. A link stands for a strip as wide as it is long, so 1 / (N/m); one along a border for half.
FUNCTION float fabricCompliance(bool row, int line) {
  int count = row ? size.y : size.x;
  float half_ = line == 0 || line == count - 1 ? 2.0f : 1.0f;
  precise float scaled = exactReciprocal(row ? stepData.fabric.weft : stepData.fabric.warp) * half_ * stepData.perDtSquared;
  return scaled;
}

// F = k (|d| - L0) d / |d| = k (1 - L0 / |d|) d, none where |d| < 1e-4 m.
FUNCTION vec3 springForce(vec3 d, float restLength, float stiffness) {
  precise float squared = exactDot(d, d);
  precise float scale = (1.0f - restLength * exactInverseSqrt(squared)) * stiffness;
  precise vec3 force = d * scale;
  return squared < 1e-8f ? vec3(0.0f) : force;
}

FUNCTION vec3 springTo(ivec2 at, vec3 here, int dx, int dy, float restLength, float stiffness) {
  precise vec3 d = vec3(loadPosition(neighbour(at, dx, dy))) - here;
  return springForce(d, restLength, stiffness);
}

FUNCTION vec3 springForces(ivec2 at, vec3 here) {
  float k = stepData.constants.stiffness;
  float restLength = springLength(0);
  precise vec3 sum = springTo(at, here, -1, 0, restLength, k) + springTo(at, here, 1, 0, restLength, k) +
                     springTo(at, here, 0, -1, restLength, k) + springTo(at, here, 0, 1, restLength, k);
  precise float shear = k * stepData.constants.shear;
  float diagonal = springLength(1);
  sum = sum + springTo(at, here, -1, -1, diagonal, shear) + springTo(at, here, 1, -1, diagonal, shear) +
        springTo(at, here, -1, 1, diagonal, shear) + springTo(at, here, 1, 1, diagonal, shear);
  precise float bend = k * stepData.constants.bend;
  float twice = springLength(2);
  sum = sum + springTo(at, here, -2, 0, twice, bend) + springTo(at, here, 2, 0, twice, bend) +
        springTo(at, here, 0, -2, twice, bend) + springTo(at, here, 0, 2, twice, bend);
  return sum;
}

// Bending of a fabric, a plate's energy of second differences, linear in the positions and so the same however it lies:
//   E = 1/2 (D / L^2) sum (|Dxx|^2 + |Dyy|^2) over nodes + sum |Dxy|^2 D / L^2 over cells.
// Borders are natural: what would reach beyond has no energy, and differences along a border count for half its area. A
// clamped border has a ghost beyond it, x[-1] = x[1] - 2 t, where t leads to its neighbour within.
FUNCTION vec3 loadPoint(ivec2 at, int dx, int dy) {
  return vec3(loadPosition(neighbour(at, dx, dy)));
}
// dE/dx of the second differences along one axis: of the nodes before, here and after.
FUNCTION vec3 bendAlong(ivec2 at, vec3 here, bool row) {
  int dx = row ? 1 : 0, dy = row ? 0 : 1;
  int k = row ? at.x : at.y, count = row ? size.x : size.y;
  vec4 before = loadPosition(neighbour(at, -dx, -dy)), after = loadPosition(neighbour(at, dx, dy));
  vec4 low = stepData.clamped[row ? 0 : 2], high = stepData.clamped[row ? 1 : 3];
  precise vec3 first = loadPoint(at, -2 * dx, -2 * dy) - 2.0f * vec3(before) + here;
  precise vec3 middle = vec3(before) - 2.0f * here + vec3(after);
  precise vec3 last = here - 2.0f * vec3(after) + loadPoint(at, 2 * dx, 2 * dy);
  precise vec3 ghostFirst = 2.0f * (here - vec3(before) - vec3(low));
  precise vec3 ghostLast = 2.0f * (here - vec3(after) - vec3(high));
  bool heldFirst = k == 1 && low.w > 0.0f && before.w == 0.0f;
  bool heldLast = k == count - 2 && high.w > 0.0f && after.w == 0.0f;
  first = k >= 2 ? first : heldFirst ? ghostFirst : vec3(0.0f);
  middle = k >= 1 && k < count - 1 ? middle : vec3(0.0f);
  last = k < count - 2 ? last : heldLast ? ghostLast : vec3(0.0f);
  int other = row ? at.y : at.x, others = row ? size.y : size.x;
  float area = other == 0 || other == others - 1 ? 0.5f : 1.0f;
  precise vec3 gradient = (first - 2.0f * middle + last) * area;
  return gradient;
}
// here - a - b + c of the cell on that side: 2 |Dxy|^2 / 2 gives twice this.
FUNCTION vec3 twist(ivec2 at, vec3 here, int dx, int dy) {
  bool there = at.x + dx >= 0 && at.y + dy >= 0 && at.x + dx < size.x && at.y + dy < size.y;
  precise vec3 cell = here - loadPoint(at, dx, 0) - loadPoint(at, 0, dy) + loadPoint(at, dx, dy);
  return there ? cell : vec3(0.0f);
}
FUNCTION vec3 bendingForce(ivec2 at, vec3 here) {
  precise vec3 twists = twist(at, here, -1, -1) + twist(at, here, 1, -1) + twist(at, here, -1, 1) + twist(at, here, 1, 1);
  precise vec3 gradient = bendAlong(at, here, true) + bendAlong(at, here, false) + 2.0f * twists;
  precise vec3 force = gradient * -stepData.perBend;
  return force;
}

// Value noise with three components in [-1, 1): a random vector at each lattice point, blended by
// 3u^2 - 2u^3.
FUNCTION vec3 latticeVector(int x, int y, int z) {
  return signedUnits(hash3(uvec3(uint(x), uint(y), uint(z) ^ (uint(stepData.seed) * 0x9e3779b9u))));
}
FUNCTION vec3 latticeRow(int x, int y, int z, float t) {
  return exactMix(latticeVector(x, y, z), latticeVector(x + 1, y, z), t);
}

FUNCTION float smoothCurve(float u) {
  precise float t = (3.0f - 2.0f * u) * u * u;
  return t;
}

FUNCTION vec3 noise(vec3 p) {
  precise vec3 base = floor(p);
  precise vec3 u = p - base;
  int x = int(base.x);
  int y = int(base.y);
  int z = int(base.z);
  float tx = smoothCurve(u.x);
  float ty = smoothCurve(u.y);
  vec3 low = exactMix(latticeRow(x, y, z, tx), latticeRow(x, y + 1, z, tx), ty);
  vec3 high = exactMix(latticeRow(x, y, z + 1, tx), latticeRow(x, y + 1, z + 1, tx), ty);
  return exactMix(low, high, smoothCurve(u.z));
}

// Air force on a corner of a face: c = a x b has twice the area of the triangle (here, a, b), and half of
// that triangle belongs to this particle, so A n = c/4. With v the air's velocity relative to the cloth:
//   drag = 1/2 rho Cd A |v.n| v,   lift = 1/2 rho Cl A (v.n) (|v|^2 n - (v.n) v) / |v|,
// the lift being perpendicular to v and zero both edge-on and face-on.
FUNCTION vec3 airForceOnFace(vec3 a, vec3 b, vec3 v, float speedSquared, float inverseSpeed) {
  vec3 c = exactCross(a, b);
  float through = exactDot(v, c);
  precise float pressure = 0.125f * stepData.air.density;
  precise float drag = pressure * stepData.air.drag * abs(through);
  float inverseArea = exactInverseSqrt(max(exactDot(c, c), 1e-24f));
  precise float lift = pressure * stepData.air.lift * through * inverseSpeed * inverseArea;
  precise vec3 force = v * drag + (c * speedSquared - v * through) * lift;
  return force;
}

FUNCTION vec3 airForces(ivec2 at, vec3 here, vec3 velocity) {
  precise vec3 place = (here - vec3(stepData.gustDrift)) * stepData.perGustSize;
  precise vec3 v = vec3(stepData.airVelocity) + noise(place) * stepData.gustSpeed - velocity;
  float speedSquared = max(exactDot(v, v), 1e-12f);
  float inverseSpeed = exactInverseSqrt(speedSquared);
  precise vec3 left = vec3(loadPosition(neighbour(at, -1, 0))) - here;
  precise vec3 right = vec3(loadPosition(neighbour(at, 1, 0))) - here;
  precise vec3 up = vec3(loadPosition(neighbour(at, 0, -1))) - here;
  precise vec3 down = vec3(loadPosition(neighbour(at, 0, 1))) - here;
  precise vec3 sum = airForceOnFace(right, up, v, speedSquared, inverseSpeed) +
                     airForceOnFace(up, left, v, speedSquared, inverseSpeed) +
                     airForceOnFace(left, down, v, speedSquared, inverseSpeed) +
                     airForceOnFace(down, right, v, speedSquared, inverseSpeed);
  return sum;
}

// v' = (v + (F w + g) dt) keep. `springs`, `air` and `fabric` switch terms off that a variant does not have.
FUNCTION vec3 newVelocity(ivec2 at, vec4 here, vec3 velocity, bool springs, bool air, bool fabric) {
  precise vec3 force = vec3(stepData.wind);
  if (fabric) force = force + bendingForce(at, vec3(here));
  if (springs) force = force + springForces(at, vec3(here));
  if (air) force = force + airForces(at, vec3(here), velocity);
  precise vec3 acceleration = force * here.w + vec3(stepData.gravity);
  precise vec3 v = (velocity + acceleration * stepData.dt) * stepData.kept;
  return v;
}

FUNCTION float applyRow(vec4 row, vec3 p) {
  precise float value = exactDot(vec3(row), p) + row.w;
  return value;
}

// Where the pin's frame carries the particle's rest position.
FUNCTION vec3 pinnedPosition(ivec2 at, int frame) {
  precise vec3 rest =
      vec3(stepData.origin) + vec3(stepData.alongX) * float(at.x) + vec3(stepData.alongY) * float(at.y);
  return vec3(applyRow(stepData.frames[frame].row0, rest), applyRow(stepData.frames[frame].row1, rest),
              applyRow(stepData.frames[frame].row2, rest));
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

// Semi-implicit Euler: x' = x + v' dt, then contact unless constraints still have to act.
FUNCTION Motion advance(ivec2 at, vec4 here, vec4 velocity, bool springs, bool air, bool fabric, bool touch,
                        bool lands, bool walled) {
  Motion m;
  if (here.w == 0.0f) {
    m.position = pinnedPosition(at, int(velocity.w));
    m.velocity = vec3(0.0f);
    return m;
  }
  m.velocity = newVelocity(at, here, vec3(velocity), springs, air, fabric);
  precise vec3 moved = vec3(here) + m.velocity * stepData.dt;
  m.position = moved;
  if (touch) m = contact(m, vec3(here), lands, walled);
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

// How far XPBD (Macklin et al. 2016; one iteration per substep, 2019) moves each end of a constraint
// C = |d| - L0 along d = b - a: lambda = -C / (wa + wb + compliance/dt^2), a -= wa lambda d/|d|, b += ...
// Returns lambda d/|d|.
FUNCTION vec3 constraintShift(vec4 a, vec4 b, float restLength, float scaledCompliance) {
  precise vec3 d = vec3(b) - vec3(a);
  float squared = max(exactDot(d, d), 1e-12f);
  float inverse = exactInverseSqrt(squared);
  precise float stretch = squared * inverse - restLength;
  precise float weight = scaledCompliance + a.w + b.w;
  precise float lambda = stretch * exactReciprocal(max(weight, 1e-20f)) * inverse;
  precise vec3 shift = d * -lambda;
  return a.w > 0.0f || b.w > 0.0f ? shift : vec3(0.0f);
}

// A position or speed no cloth should have.
FUNCTION bool isLost(Motion m) {
  float distanceSquared = exactDot(m.position, m.position);
  float speedSquared = exactDot(m.velocity, m.velocity);
  bool numbers = isNumber(distanceSquared) && isNumber(speedSquared);
  return !numbers || distanceSquared > 1e10f || speedSquared > 1e10f;
}

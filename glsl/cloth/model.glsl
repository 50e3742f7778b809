// One particle of a sheet (a grid of particles) over one substep. Compiles as GLSL and as C++ (the CPU twin of the
// tests). The including file provides `size` (ivec2), `keeps` (bool), `stepData` (ClothStep) and loadPosition(int), and
// first includes types.glsl, common/exact.glsl, common/hash.glsl, mesh/height_model.glsl and contour/wall_model.glsl.
#include "cloth/air.glsl"
#include "cloth/motion.glsl"

FUNCTION int neighbour(ivec2 at, int dx, int dy) {
  // A neighbour beyond the border is replaced by the particle itself, so that the spring has length zero and no force.
  int x = at.x + dx;
  int y = at.y + dy;
  bool inside = x >= 0 && y >= 0 && x < size.x && y < size.y;
  return inside ? y * size.x + x : at.y * size.x + at.x;
}

// Returns the rest length in metres of a kind of link: 0 structural, 1 shear, 2 bending.
FUNCTION float springLength(int kind) {
  float ratio = kind == 0 ? 1.0f : kind == 1 ? 1.41421356f : 2.0f;
  precise float restLength = stepData.constants.spacing * ratio;
  return restLength;
}
// Returns compliance / h^2 of a kind of link. Damping reduces it through complianceScale.
FUNCTION float scaledCompliance(int kind) {
  float compliance = kind == 0   ? stepData.constants.compliance
                     : kind == 1 ? stepData.constants.shearCompliance
                                 : stepData.constants.bendCompliance;
  precise float scaled = compliance * stepData.complianceScale;
  return scaled;
}
// Returns the scaled compliance of the links of a fabric's row or column. A link stands for a strip that is as wide as
// the link is long, so its compliance is 1 / stiffness, with the stiffness in N/m. A link along a border stands for
// half a strip, so its compliance is twice as large.
FUNCTION float fabricCompliance(bool row, int line) {
  int count = row ? size.y : size.x;
  float half_ = line == 0 || line == count - 1 ? 2.0f : 1.0f;
  precise float scaled = exactReciprocal(row ? stepData.fabric.weft : stepData.fabric.warp) * half_ * stepData.complianceScale;
  return scaled;
}

// Returns the force F = k (|d| - L0) d / |d| = k (1 - L0 / |d|) d of a spring with the vector d, rest length L0 and
// stiffness k, or zero if |d| < 1e-4 m.
FUNCTION vec3 springForce(vec3 d, float restLength, float stiffness) {
  float squared = exactDot(d, d);
  precise float scale = (1.0f - restLength * exactInverseSqrt(squared)) * stiffness;
  float held = squared < 1e-8f ? 0.0f : scale;
  precise vec3 force = d * held;
  return force;
}

FUNCTION vec3 springTo(int there, vec3 here, float restLength, float stiffness) {
  precise vec3 d = vec3(loadPosition(there)) - here;
  return springForce(d, restLength, stiffness);
}

FUNCTION vec3 springForces(ivec2 at, vec3 here) {
  // These are the neighbours that neighbour() returns, but with only one border test per direction.
  int w = size.x, i = at.y * w + at.x;
  bool left = at.x > 0, right = at.x + 1 < w, above = at.y > 0, below = at.y + 1 < size.y;
  int up = above ? i - w : i, down = below ? i + w : i;
  float k = stepData.constants.stiffness;
  float restLength = springLength(0);
  precise vec3 sum = springTo(left ? i - 1 : i, here, restLength, k) + springTo(right ? i + 1 : i, here, restLength, k) +
                     springTo(up, here, restLength, k) + springTo(down, here, restLength, k);
  precise float shear = k * stepData.constants.shear;
  float diagonal = springLength(1);
  sum = sum + springTo(left && above ? up - 1 : i, here, diagonal, shear) +
        springTo(right && above ? up + 1 : i, here, diagonal, shear) +
        springTo(left && below ? down - 1 : i, here, diagonal, shear) +
        springTo(right && below ? down + 1 : i, here, diagonal, shear);
  precise float bend = k * stepData.constants.bend;
  float twice = springLength(2);
  sum = sum + springTo(at.x > 1 ? i - 2 : i, here, twice, bend) + springTo(at.x + 2 < w ? i + 2 : i, here, twice, bend) +
        springTo(at.y > 1 ? i - 2 * w : i, here, twice, bend) +
        springTo(at.y + 2 < size.y ? i + 2 * w : i, here, twice, bend);
  return sum;
}

#include "cloth/bending.glsl"
#include "cloth/keeping.glsl"

FUNCTION vec3 airForces(ivec2 at, vec3 here, vec3 velocity) {
  precise vec3 place = (here - vec3(stepData.gustDrift)) * stepData.perGustSize;
  precise vec3 v = vec3(stepData.airVelocity) + noise(place) * stepData.gustSpeed - velocity;
  if (blown) v = v + windAt(here);
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

// Returns v' = (v + (F w + g) dt) kept for the velocity v, the force F, the inverse mass w and gravity g. `springs`,
// `air` and `fabric` are false for terms that a kernel variant lacks.
FUNCTION vec3 newVelocity(ivec2 at, vec4 here, vec3 velocity, bool springs, bool air, bool fabric) {
  precise vec3 force = vec3(stepData.wind);
  if (fabric) force = force + bendingForce(at, vec3(here));
  if (springs) force = force + springForces(at, vec3(here));
  if (keeps) force = force + pairForces(at, here, fabric);
  if (air) force = force + airForces(at, vec3(here), velocity);
  precise vec3 acceleration = force * here.w + vec3(stepData.gravity);
  precise vec3 v = (velocity + acceleration * stepData.dt) * stepData.kept;
  return v;
}

// Returns the target of a pinned particle: its rest position transformed by its pin group.
FUNCTION vec3 pinnedPosition(ivec2 at, int group) {
  int frame = max(group, 0);
  precise vec3 rest =
      vec3(stepData.origin) + vec3(stepData.alongX) * float(at.x) + vec3(stepData.alongY) * float(at.y);
  return vec3(applyRow(stepData.frames[frame].row0, rest), applyRow(stepData.frames[frame].row1, rest),
              applyRow(stepData.frames[frame].row2, rest));
}

// Performs a semi-implicit Euler step, x' = x + v' dt. If `springs` is false, the caller applies constraints
// afterwards; the position is then extrapolated by `trend` (ledTo), the velocity change by constraints in the previous
// substep (motion.glsl). `touch` enables contact; `lands` and `walled` add contact with the colliding mesh and with
// solids.
FUNCTION Motion advance(ivec2 at, vec4 here, vec4 velocity, vec3 trend, bool springs, bool air, bool fabric, bool touch,
                        bool lands, bool walled) {
  Motion m;
  m.velocity = newVelocity(at, here, vec3(velocity), springs, air, fabric);
  precise vec3 moved = vec3(here) + m.velocity * stepData.dt;
  m.position = moved;
  if (!springs) m.position = ledTo(vec3(here), m.velocity, trend);
  if (touch) m = contact(m, vec3(here), lands, walled);
  if (here.w == 0.0f) {  // This test comes last, so that the GPU can load the neighbours without waiting for the
                         // inverse mass.
    // Target written by cloth/hold.comp
    m.position = velocity.w < 0.0f ? vec3(velocity) : pinnedPosition(at, int(velocity.w));
    m.velocity = vec3(0.0f);
  }
  return m;
}

// Position correction of an XPBD constraint C = |d| - L0 between the particles a and b, where d = b - a, wa and wb are
// inverse masses and L0 is the rest length (Macklin et al. 2016; one iteration per substep, 2019): lambda = -C / (wa +
// wb + compliance/h^2), a -= wa lambda d/|d|, b += wb lambda d/|d|. constraintShift() returns lambda d/|d|. It does not
// correct `kept` metres of the stretch.
//
// keptStretch() returns `kept` for damping along the edge. A damped fabric resists with k (C + T dC/dt). With g = T /
// dt, XPBD solves C' + compliance/dt^2 lambda + g (C' - C_before) = 0 (here with compliance/h^2). This equals the
// undamped constraint with C - g/(1+g) C_before in place of C, and compliance / (1+g). Only lengths are damped, so
// rotation and translation without stretch are not.
FUNCTION float keptStretch(vec4 a, vec4 b, float restLength) {
  precise vec3 d = vec3(b) - vec3(a);
  float squared = max(exactDot(d, d), 1e-12f);
  precise float kept = (squared * exactInverseSqrt(squared) - restLength) * stepData.dampedPart;
  return kept;
}
FUNCTION vec3 constraintShift(vec4 a, vec4 b, float restLength, float scaledCompliance, float kept) {
  precise vec3 d = vec3(b) - vec3(a);
  float squared = max(exactDot(d, d), 1e-12f);
  float inverse = exactInverseSqrt(squared);
  precise float stretch = squared * inverse - restLength - kept;
  precise float weight = scaledCompliance + a.w + b.w;
  precise float lambda = stretch * exactReciprocal(max(weight, 1e-20f)) * inverse;
  precise vec3 shift = d * -lambda;
  return a.w > 0.0f || b.w > 0.0f ? shift : vec3(0.0f);
}

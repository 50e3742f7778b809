// One particle over one substep of a leapfrog (kick, drift, kick), without the mutual gravity. Compiles as GLSL and as
// C++ (the CPU twin of the tests). The including file provides `stepData` (ParticleStep), types.glsl,
// common/exact.glsl, common/hash.glsl, particles/pairs.glsl, particles/pace.glsl, mesh/height_model.glsl,
// contour/wall_model.glsl, particles/contact/scale.glsl, and `blown` and windAt() (fluid/wind_array.glsl).
#include "collide/model.glsl"
#include "particles/ring.glsl"

struct ParticleMotion {
  vec4 position;  // xyz position, m; w mass, kg (0 if not alive)
  vec4 velocity;  // xyz velocity, m/s; w age as a fraction of life, 0 to 1 (negative if not alive)
#ifdef ROLLS
  vec3 spin;      // As in Motion
  vec3 roll;
#endif
};

// Returns the motion of a particle that does not turn.
FUNCTION ParticleMotion particleMotion(vec4 position, vec4 velocity) {
  ParticleMotion m;
  m.position = position;
  m.velocity = velocity;
#ifdef ROLLS
  m.spin = vec3(0.0f);
  m.roll = vec3(0.0f);
#endif
  return m;
}

#ifdef ROLLS
// Returns the radius of a particle as a ball that turns, in metres.
FUNCTION float turningRadius(float mass) {
  precise float radius = stepData.balls.radius * ballScale(mass);
  return max(radius, 1e-20f);
}

// Returns the motion of a ball with the angular velocity `spin` (xyz, rad/s).
FUNCTION ParticleMotion turning(ParticleMotion m, vec4 spin) {
  precise vec3 speed = vec3(spin) * turningRadius(m.position.w);
  precise vec3 roll = speed * stepData.dt;
  m.spin = speed;
  m.roll = roll;
  return m;
}

// Returns the angular velocity (xyz, rad/s) of a ball.
FUNCTION vec4 spinOf(ParticleMotion m) {
  precise vec3 spin = m.spin * exactReciprocal(turningRadius(m.position.w));
  return vec4(spin, 0.0f);
}
#endif

// Returns the upper 24 bits of a word as a number in [0, 1), without rounding.
FUNCTION float unit(uint bits) {
  precise float u = float(int(bits >> 8u)) * 5.9604645e-8f;
  return u;
}

FUNCTION uvec3 randomWords(int item, int purpose, int draw) {
  return hash3(uvec3(uint(item), uint(purpose * 8 + draw), uint(stepData.seed) * 0x9e3779b9u));
}

// Returns 6u^5 - 15u^4 + 10u^3. Its first and second derivatives vanish at 0 and 1.
FUNCTION float quintic(float u) {
  precise float s = ((u * 6.0f - 15.0f) * u + 10.0f) * u * u * u;
  return s;
}

// Returns the derivative of quintic(), 30 u^2 (u - 1)^2.
FUNCTION float quinticSlope(float u) {
  precise float root = (u - 1.0f) * u;
  precise float s = root * root * 30.0f;
  return s;
}

FUNCTION vec3 latticePotential(int x, int y, int z) {
  return signedUnits(hash3(uvec3(uint(x), uint(y), uint(z) ^ (uint(stepData.seed) * 0x85ebca6bu))));
}

// Returns the curl of a value-noise vector potential psi at p, in lattice units. It is divergence-free: curl psi =
// (dpsi_z/dy - dpsi_y/dz, dpsi_x/dz - dpsi_z/dx, dpsi_y/dx - dpsi_x/dy). The derivatives of the interpolation between
// the eight corners are computed exactly. A factor scales the root mean square to 1; without it, 1.873 was measured.
FUNCTION vec3 curlNoise(vec3 p) {
  precise vec3 base = clamp(floor(p), -1e6f, 1e6f);
  precise vec3 u = p - base;
  u = min(max(u, 0.0f), 1.0f);
  int x = int(base.x);
  int y = int(base.y);
  int z = int(base.z);
  float tx = quintic(u.x);
  float ty = quintic(u.y);
  float tz = quintic(u.z);
  vec3 c000 = latticePotential(x, y, z);
  vec3 c100 = latticePotential(x + 1, y, z);
  vec3 c010 = latticePotential(x, y + 1, z);
  vec3 c110 = latticePotential(x + 1, y + 1, z);
  vec3 c001 = latticePotential(x, y, z + 1);
  vec3 c101 = latticePotential(x + 1, y, z + 1);
  vec3 c011 = latticePotential(x, y + 1, z + 1);
  vec3 c111 = latticePotential(x + 1, y + 1, z + 1);
  precise vec3 dx = (exactMix(exactMix(c100, c110, ty), exactMix(c101, c111, ty), tz) -
                     exactMix(exactMix(c000, c010, ty), exactMix(c001, c011, ty), tz)) * quinticSlope(u.x);
  precise vec3 dy = (exactMix(exactMix(c010, c110, tx), exactMix(c011, c111, tx), tz) -
                     exactMix(exactMix(c000, c100, tx), exactMix(c001, c101, tx), tz)) * quinticSlope(u.y);
  precise vec3 dz = (exactMix(exactMix(c001, c101, tx), exactMix(c011, c111, tx), ty) -
                     exactMix(exactMix(c000, c100, tx), exactMix(c010, c110, tx), ty)) * quinticSlope(u.z);
  precise vec3 curl = (vec3(dy.z, dz.x, dx.y) - vec3(dz.y, dx.z, dy.x)) * 0.5338f;
  return curl;
}

// Interpolates linearly from `end` (fraction 0) to `start` (fraction 1).
FUNCTION vec4 backTo(vec4 end, vec4 start, float fraction) {
  precise vec4 sum = (start - end) * fraction + end;
  return sum;
}

// Returns the fields at a time within the substep: the fraction `fraction` of the substep before its end.
FUNCTION ParticleFields fieldsAt(float fraction) {
  ParticleFields f;
  f.acceleration = backTo(stepData.fields.acceleration, stepData.fieldsBefore.acceleration, fraction);
  f.attractor = backTo(stepData.fields.attractor, stepData.fieldsBefore.attractor, fraction);
  f.turbulenceDrift = backTo(stepData.fields.turbulenceDrift, stepData.fieldsBefore.turbulenceDrift, fraction);
  return f;
}

// Returns the acceleration by fields, without mutual gravity. `attractor` and `turbulence` enable the terms of these
// names.
FUNCTION vec3 fieldAcceleration(ParticleFields fields, vec3 here, bool attractor, bool turbulence) {
  precise vec3 sum = vec3(fields.acceleration);
  if (attractor) {
    float softening = stepData.constants.attractorSoftening;
    precise float squared = softening * softening;
    sum = sum + addPull(vec3(0.0f), here, fields.attractor, squared);
  }
  if (turbulence) {
    precise vec3 place = (here - vec3(fields.turbulenceDrift)) * stepData.perTurbulenceSize;
    sum = sum + curlNoise(place) * stepData.turbulence.strength;
  }
  if (blown) sum = sum + windAt(here) * stepData.windDrag;
  return sum;
}

// Returns a point of the unit sphere, uniformly distributed for `height` uniform in [-1, 1) and `turn` uniform in [0,
// 1).
FUNCTION vec3 onSphere(float height, float turn) {
  precise float angle = turn * 6.2831853f;
  precise float squared = 1.0f - height * height;
  float across = exactSqrt(squared);
  precise float x = across * exactCos(angle);
  precise float z = across * exactSin(angle);
  return vec3(x, height, z);
}

// Returns the lifetime of the particles of a slot, in seconds. All particles of a slot have the same lifetime, so that
// no slot is reused before its particle dies.
FUNCTION float lifetimeOf(int slot, int e) {
  EmitterConstants emitter = stepData.emitters[e].constants;
  float variation = signedUnit(randomWords(slot, e, 0).x);
  precise float lifetime = (variation * emitter.lifetimeVariation + 1.0f) * emitter.lifetime;
  return lifetime;
}

// Returns the slot of new particle k: the inverse of ringPlace.
FUNCTION int newbornSlot(int e, int k) {
  int slots = stepData.emitters[e].slots;
  int place = stepData.emitters[e].firstPlace + k;
  return stepData.emitters[e].firstSlot + (place < slots ? place : place - slots);
}

// Returns the time in seconds that new particle k of emitter e has lived at the end of the substep.
FUNCTION float livedSeconds(int e, int k) {
  precise float lived = stepData.emitters[e].firstLived - float(k) * stepData.emitters[e].birthInterval;
  return min(max(lived, 0.0f), stepData.dt);
}

// Applies the first kick and the drift: v' = v + a firstKick, x' = x + v' drift.
FUNCTION ParticleMotion drifted(ParticleMotion m, vec3 acceleration, Pace pace) {
  precise vec3 v = vec3(m.velocity) + acceleration * pace.firstKick;
  precise vec3 x = vec3(m.position) + v * pace.drift;
  m.position = vec4(x, m.position.w);
  m.velocity = vec4(v, m.velocity.w);
  return m;
}

FUNCTION ParticleMotion grownOlder(ParticleMotion m, float seconds, int slot, int e) {
  precise float age = seconds * exactReciprocal(lifetimeOf(slot, e)) + m.velocity.w;
  m.velocity.w = age;
  if (age >= 1.0f) {
    m.velocity.w = -1.0f;
    m.position.w = 0.0f;
  }
  return m;
}

// Applies the first kick and the drift to a particle that was born before the substep. Particles of emitters also age
// and die.
FUNCTION ParticleMotion moved(int i, vec4 position, vec4 velocity, vec3 acceleration) {
  ParticleMotion m = particleMotion(position, velocity);
  if (velocity.w < 0.0f) return m;
  m = drifted(m, acceleration, stepData.pace);
  ivec2 place = ringPlace(i);
  if (place.x >= 0) m = grownOlder(m, stepData.dt, i, place.x);
  return m;
}

// Returns new particle k of emitter e at its birth, with age 0. The fraction `fraction` of the substep remains after
// the birth.
FUNCTION ParticleMotion newborn(int e, int k, float fraction) {
  EmitterStep emitter = stepData.emitters[e];
  vec4 mean = backTo(emitter.velocity, emitter.velocityBefore, fraction);
  float meanSquared = exactDot(vec3(mean), vec3(mean));
  precise vec3 scaled = vec3(mean) * exactInverseSqrt(meanSquared);
  vec3 forward = meanSquared < 1e-30f ? vec3(0.0f, 1.0f, 0.0f) : scaled;
  vec3 across = exactCross(forward, abs(forward.y) < 0.9f ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f));
  precise vec3 side = across * exactInverseSqrt(exactDot(across, across));
  vec3 up = exactCross(forward, side);
  int serial = emitter.firstSerial + k;
  uvec3 a = randomWords(serial, e, 1);
  uvec3 b = randomWords(serial, e, 2);
  uvec3 c = randomWords(serial, e, 3);
  // The direction is uniform in a cone with h = 1 - cos = u (1 - cos spread) for a uniform u, and sin^2 = h (2 - h).
  // This form avoids cancellation.
  precise float height = unit(a.x) * emitter.coneHeight;
  precise float cosine = 1.0f - height;
  precise float squared = (2.0f - height) * height;
  float sine = exactSqrt(max(squared, 0.0f));
  precise float angle = unit(a.y) * 6.2831853f;
  precise float sideways = sine * exactCos(angle);
  precise float upwards = sine * exactSin(angle);
  precise float speed = (signedUnit(a.z) * emitter.constants.speedVariation + 1.0f) * exactSqrt(meanSquared);
  precise vec3 velocity = (forward * cosine + side * sideways + up * upwards) * speed;
  // The maximum of three uniform numbers is distributed like the radius of a point in a ball.
  precise float radius = max(max(unit(c.x), unit(c.y)), unit(c.z)) * emitter.constants.radius;
  precise vec3 place = vec3(backTo(emitter.position, emitter.positionBefore, fraction)) +
                       onSphere(signedUnit(b.x), unit(b.y)) * radius;
  return particleMotion(vec4(place, emitter.constants.mass), vec4(velocity, 0.0f));
}

// Returns new particle k of emitter e after the first kick and drift over the remaining part of the substep, with the
// fields at its birth.
FUNCTION ParticleMotion newbornMoved(int e, int k, bool attractor, bool turbulence) {
  float lived = livedSeconds(e, k);
  precise float fraction = lived * exactReciprocal(stepData.dt);
  fraction = min(fraction, 1.0f);
  ParticleMotion m = newborn(e, k, fraction);
  vec3 acceleration = fieldAcceleration(fieldsAt(fraction), vec3(m.position), attractor, turbulence);
  m = drifted(m, acceleration, paceOf(lived, stepData.constants.damping));
  return grownOlder(m, lived, newbornSlot(e, k), e);
}

// Moves a particle out of shapes and rigid meshes, after the drift from `from`.
FUNCTION ParticleMotion outOfSolids(ParticleMotion m, vec3 from) {
  bool alive = m.velocity.w >= 0.0f;
  Motion here;
  here.position = vec3(m.position);
  here.velocity = vec3(m.velocity);
#ifdef ROLLS
  here.spin = m.spin;
  here.roll = m.roll;
#endif
  precise float margin = stepData.constants.margin * ballScale(m.position.w);
  Motion out_ = outOfShapes(here, from, margin, stepData.constants.bounce);
  out_ = outOfMeshes(out_, from, margin, stepData.constants.bounce);
  m.position = alive ? vec4(out_.position, m.position.w) : m.position;
  m.velocity = alive ? vec4(out_.velocity, m.velocity.w) : m.velocity;
#ifdef ROLLS
  m.spin = alive ? out_.spin : m.spin;
  m.roll = alive ? out_.roll : m.roll;
#endif
  return m;
}

// Moves a particle out of the colliding height mesh. Call it after outOfSolids().
FUNCTION ParticleMotion overHeights(ParticleMotion m) {
  Landing l = landed(vec3(m.position), vec3(m.velocity));
  bool alive = m.velocity.w >= 0.0f;
  m.position = alive ? vec4(l.position, m.position.w) : m.position;
  m.velocity = alive ? vec4(l.velocity, m.velocity.w) : m.velocity;
  return m;
}

// Moves a particle out of the walls of a solid, after the drift from `from`. Call it after overHeights().
FUNCTION ParticleMotion besideWalls(ParticleMotion m, vec3 from) {
  bool alive = m.velocity.w >= 0.0f;
  vec3 here = alive ? vec3(m.position) : from;
  WallMotion w = outOfWalls(from, here, vec3(m.velocity));
  m.position = alive ? vec4(w.position, m.position.w) : m.position;
  m.velocity = alive ? vec4(w.velocity, m.velocity.w) : m.velocity;
  return m;
}

// Applies the damping and the second kick: v' = v kept + a secondKick.
FUNCTION vec4 kicked(vec4 velocity, vec3 acceleration, Pace pace) {
  precise vec3 v = vec3(velocity) * pace.kept + acceleration * pace.secondKick;
  return velocity.w < 0.0f ? velocity : vec4(v, velocity.w);
}

// Applies the pull of the other particles to a new particle. The pull is known only at the end of the drift. It is also
// used as an approximation of the pull at the birth, so this function adds the missing first kick and the drift that it
// causes.
FUNCTION ParticleMotion pulledSinceBirth(ParticleMotion m, vec3 pull, Pace pace) {
  precise vec3 kick = pull * pace.firstKick;
  precise vec3 x = vec3(m.position) + kick * pace.drift;
  precise vec3 v = vec3(m.velocity) + kick;
  m.position = vec4(x, m.position.w);
  m.velocity = vec4(v, m.velocity.w);
  return m;
}

// Returns true if position or speed exceeds 1e8 or is NaN, because the range of exact.glsl ends there.
FUNCTION bool isLost(vec4 position, vec4 velocity) {
  float distanceSquared = exactDot(vec3(position), vec3(position));
  float speedSquared = exactDot(vec3(velocity), vec3(velocity));
  bool numbers = isNumber(distanceSquared) && isNumber(speedSquared);
  return velocity.w >= 0.0f && (!numbers || distanceSquared > 1e16f || speedSquared > 1e16f);
}

// One vertex or face of cloth made of triangles, over one substep. Compiles as GLSL and as C++ (the CPU twin of the
// tests). The including file provides `stepData` (ClothStep), `keeps` (bool), loadPoint(int) -> vec3, loadEntry(int) ->
// uvec4, loadRing(int) -> uvec4, loadElement(int) -> vec4 and loadFaceForce(int) -> vec3, and first includes
// types.glsl, common/exact.glsl, common/hash.glsl, mesh/height_model.glsl and contour/wall_model.glsl. A fan (uvec4)
// describes a vertex: x is the index of its first ring, y the number of rings (one per adjacent face), z the index of
// its first element of bending entries, w the number of such elements.
#include "cloth/air.glsl"
#include "cloth/motion.glsl"
#include "garment/membrane.glsl"

// Returns the bending force F_i = -sum K_ij (x_j - x_i), the negative gradient of the plate energy
// (src/sim/garment/plate.hpp). Each element holds two entries (j, K_ij).
FUNCTION vec3 bendingForce(uvec4 fan, vec3 here) {
  precise vec3 force = vec3(0.0f);
  for (uint k = 0u; k < fan.w; ++k) {
    uvec4 entry = loadEntry(int(fan.z + k));
    precise vec3 first = loadPoint(int(entry.x)) - here;
    precise vec3 second = loadPoint(int(entry.z)) - here;
    force = force - first * intBitsToFloat(int(entry.y)) - second * intBitsToFloat(int(entry.w));
  }
  return force;
}

// Returns the air force on each corner of a face, which is a third of the force on the face. airForceOnFace() is for a
// grid, where a corner has the area vector c / 4. Here the area vector is c / 6, so the result is multiplied by 2/3.
// `velocity` is the mean of the corners' velocities.
FUNCTION vec3 airOnCorner(vec3 a, vec3 b, vec3 c, vec3 velocity) {
  precise vec3 middle = (a + b + c) * 0.33333333f;
  precise vec3 place = (middle - vec3(stepData.gustDrift)) * stepData.perGustSize;
  precise vec3 v = vec3(stepData.airVelocity) + noise(place) * stepData.gustSpeed - velocity;
  if (blown) v = v + windAt(middle);
  float speedSquared = max(exactDot(v, v), 1e-12f);
  float inverseSpeed = exactInverseSqrt(speedSquared);
  precise vec3 left = b - a;
  precise vec3 right = c - a;
  precise vec3 third = airForceOnFace(left, right, v, speedSquared, inverseSpeed) * 0.66666667f;
  return third;
}

FUNCTION vec3 airForces(uvec4 fan) {
  precise vec3 force = vec3(0.0f);
  for (uint k = 0u; k < fan.y; ++k) force = force + loadFaceForce(int(loadRing(int(fan.x + k)).z));
  return force;
}

// Returns the sum of the membrane forces of the faces around a vertex. w of a ring is the index of the vertex among the
// face's corners.
FUNCTION vec3 membraneForces(uvec4 fan, vec3 here) {
  precise vec3 force = vec3(0.0f);
  for (uint k = 0u; k < fan.y; ++k) {
    uvec4 ring = loadRing(int(fan.x + k));
    precise vec3 left = loadPoint(int(ring.x)) - here;
    precise vec3 right = loadPoint(int(ring.y)) - here;
    vec4 shape = shapeFrom(loadElement(2 * int(ring.z)), ring.w);
    force = force + membraneForce(left, right, shape, vec3(loadElement(2 * int(ring.z) + 1)));
  }
  return force;
}

// Returns the velocity u = (v + (F w + g) dt) kept and the predicted position, for the velocity v, the force F, the
// inverse mass w and gravity g. A pinned vertex moves to its rest position, transformed by its pin group; its rest
// position is in `trend`.
FUNCTION Motion predicted(uvec4 fan, vec4 here, vec4 velocity, vec3 trend, bool air) {
  Motion m;
  if (here.w == 0.0f) {
    int frame = max(int(velocity.w), 0);
    vec3 carried = vec3(applyRow(stepData.frames[frame].row0, trend), applyRow(stepData.frames[frame].row1, trend),
                        applyRow(stepData.frames[frame].row2, trend));
    m.position = velocity.w < 0.0f ? vec3(velocity) : carried;  // Target written by cloth/hold.comp
    m.velocity = vec3(0.0f);
    return m;
  }
  precise vec3 force = vec3(stepData.wind) + bendingForce(fan, vec3(here));
  if (air) force = force + airForces(fan);
  if (keeps) force = force + membraneForces(fan, vec3(here));
  precise vec3 acceleration = force * here.w + vec3(stepData.gravity);
  precise vec3 v = (vec3(velocity) + acceleration * stepData.dt) * stepData.kept;
  m.velocity = v;
  m.position = ledTo(vec3(here), v, trend);
  return m;
}

// Returns the vertex normal: the sum of (b - a) x (c - a) over the faces a, b, c around the vertex a, normalized.
// Returns +y if all faces are degenerate.
FUNCTION vec3 normalAt(uvec4 fan, vec3 here) {
  precise vec3 sum = vec3(0.0f);
  for (uint k = 0u; k < fan.y; ++k) {
    uvec4 ring = loadRing(int(fan.x + k));
    precise vec3 left = loadPoint(int(ring.x)) - here;
    precise vec3 right = loadPoint(int(ring.y)) - here;
    sum = sum + exactCross(left, right);
  }
  float squared = exactDot(sum, sum);
  precise vec3 unit = sum * exactInverseSqrt(max(squared, 1e-30f));
  return squared < 1e-30f ? vec3(0.0f, 1.0f, 0.0f) : unit;
}

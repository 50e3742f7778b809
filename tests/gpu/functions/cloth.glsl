#include "cloth/types.glsl"

// The members of ClothStep that the tested functions need.
struct ToldCloth {
  vec4 gravity, wind, airVelocity, gustDrift, origin, alongX, alongY;
  vec4 clamped[4];
  float dt, perDt, perReach, trendDt, complianceScale, kept, gustSpeed, perGustSize, thinRoom, perBend, dampedPart, softening;
  int colliderCount, seed;
  ClothConstants constants;
  FabricConstants fabric;
  AirConstants air;
  Collider colliders[2];
  PinFrame frames[2];
};
ToldCloth stepData;
ivec2 size;
bool keeps;
int sheet;
int lineLinks;
float lineRest, lineCompliance, lineGive, lineKept, lineSoftening;
float lineLower[segmentLinks + 1];
float lineMass[segmentLinks + 1];
float lineStretch[segmentLinks];

#include "gpu/functions/solids_none.glsl"

// Returns a particle of a creased sheet. One particle in five is pinned.
FUNCTION vec4 loadPosition(int i) {
  vec3 off = somePlace(i, sheet);
  int row = i / 5;
  precise vec3 place = vec3(0.5f * float(i - 5 * row), 0.5f * float(row), 0.0f) + 0.25f * off;
  return vec4(place, diced(i, sheet + 1).x % 5u == 0u ? 0.0f : 2.0f);
}
FUNCTION vec4 lineParticle(int k) {
  precise vec3 place = vec3(0.5f * float(k), 0.0f, 0.0f) + 0.25f * somePlace(k, sheet + 2);
  bool pinned = (k == 0 && sheet % 3 == 0) || (k == lineLinks && sheet % 4 < 2) || diced(k, sheet + 3).x % 7u == 0u;
  return vec4(place, pinned ? 0.0f : 2.0f);
}
FUNCTION vec4 lineBefore(int k) {
  vec4 now = lineParticle(k);
  precise vec3 place = vec3(now) + 0.125f * somePlace(k, sheet + 4);
  return vec4(place, now.w);
}

#include "cloth/line_model.glsl"
#include "cloth/model.glsl"
#include "cloth/segment.glsl"
#include "collide/closest.glsl"
#include "cloth/thin.glsl"

FUNCTION void prepare(int i) {
  sheet = 8 * i;
  size = ivec2(5, 4);
  keeps = i % 3 == 0;
  blow(i % 4 == 0);
  stepData.gravity = vec4(0.0f, -10.0f, 0.0f, 0.0f);
  stepData.wind = vec4(0.25f, 0.0f, 0.125f, 0.0f);
  stepData.airVelocity = vec4(2.0f, 0.0f, -1.0f, 0.0f);
  stepData.gustDrift = vec4(0.25f, 0.5f, 0.75f, 0.0f);
  stepData.origin = vec4(-0.5f, 1.0f, 0.0f, 0.0f);
  stepData.alongX = vec4(0.5f, 0.0f, 0.0f, 0.0f);
  stepData.alongY = vec4(0.0f, -0.5f, 0.125f, 0.0f);
  for (int k = 0; k < 4; ++k) stepData.clamped[k] = vec4(somePlace(i, 40 + k), i % 2 == 0 ? 1.0f : 0.0f);
  stepData.dt = 0.0625f;
  stepData.perDt = 16.0f;
  stepData.perReach = 24.0f;
  stepData.trendDt = 0.00390625f;
  stepData.complianceScale = 256.0f;
  stepData.kept = 0.875f;
  stepData.gustSpeed = 1.5f;
  stepData.perGustSize = 0.75f;
  stepData.thinRoom = 0.25f;
  stepData.perBend = 0.375f;
  stepData.dampedPart = 0.25f;
  stepData.softening = i % 2 == 0 ? 1.5f : 6.0f;
  stepData.colliderCount = 2;
  stepData.seed = 5;
  stepData.constants.spacing = 0.5f;
  stepData.constants.stiffness = 40.0f;
  stepData.constants.shear = 0.75f;
  stepData.constants.bend = 0.25f;
  stepData.constants.compliance = 0.001f;
  stepData.constants.shearCompliance = 0.002f;
  stepData.constants.bendCompliance = 0.01f;
  stepData.constants.margin = 0.03125f;
  stepData.fabric.weft = 100.0f;
  stepData.fabric.warp = 150.0f;
  stepData.air.density = 1.25f;
  stepData.air.drag = 0.75f;
  stepData.air.lift = 0.5f;
  for (int k = 0; k < 2; ++k) {
    vec3 a = somePlace(i, 50 + k), b = i % 5 == 0 ? a : somePlace(i, 52 + k);
    precise vec3 axis = b - a;
    float square = exactDot(axis, axis);
    stepData.colliders[k].a = vec4(a, 0.0f);
    stepData.colliders[k].b = vec4(b, 0.0f);
    stepData.colliders[k].velocityA = vec4(somePlace(i, 54 + k), 0.0f);
    stepData.colliders[k].velocityB = vec4(somePlace(i, 56 + k), 0.0f);
    stepData.colliders[k].reach = 0.125f;
    stepData.colliders[k].perLengthSquared = square > 0.0f ? exactReciprocal(square) : 0.0f;
    stepData.colliders[k].grip = 0.5f;
    stepData.colliders[k].plane = 0;
    stepData.colliders[k].friction = i % 3 == 0 ? -1.0f : 0.5f;
    stepData.frames[k].row0 = vec4(0.0f, 1.0f, 0.0f, 0.25f);
    stepData.frames[k].row1 = vec4(-1.0f, 0.0f, 0.0f, 0.5f);
    stepData.frames[k].row2 = vec4(0.0f, 0.0f, 1.0f, float(k));
  }
}

// Returns results of the solver for the first segment of a line that separators divide. The line has up to 20 links.
FUNCTION vec4 askedOfLine(int i) {
  lineLinks = 2 + someOf(i, 1, 19);
  lineRest = 0.5f;
  lineCompliance = i % 3 == 0 ? 0.25f : 0.0f;
  lineKept = i % 4 == 0 ? 0.25f : 0.0f;
  lineSoftening = i % 5 == 0 ? 2.0f : 1.0f;
  int links = min(lineLinks, segmentLinks);
  float longer = readSegment(0, links - 1);
  float pins = pinsOf(0, links);
  lineGive = i % 2 == 0 ? edgeComplianceOf(longer, pins > 1.0f) : minCompliance(pins);
  Reach first = firstOfSegment(links);
  Reach last = lastOfSegment(links);
  LineRow row = separatorRow(last, first);
  solveSegment(links, 0.125f, someNumber(diced(i, 2).x));
  int k = someOf(i, 3, links);
  vec3 pull = keptPull(k, k > 0 ? lineStretch[k - 1] : 0.0f, lineStretch[k], k + 1 < links ? lineStretch[k + 1] : 0.0f);
  precise float reaches = first.fixed_ + 2.0f * first.left + 4.0f * last.fixed_ + 8.0f * last.right;
  precise float rows = row.diagonal + 2.0f * row.upper + 4.0f * row.right + 8.0f * lineGive;
  if (i % 4 < 2) return vec4(pull, reaches);
  vec4 moved = pulled(lineParticle(k), pull, somePlace(i, 4));
  precise vec3 both = vec3(moved) + 2.0f * sped(somePlace(i, 5), moved.w, pull, somePlace(i, 6));
  return vec4(both, rows);
}

FUNCTION vec4 asked(int i) {
  prepare(i);
  ivec2 at = ivec2(someOf(i, 7, 5), someOf(i, 8, 4));
  int place = at.y * size.x + at.x;
  vec4 here = loadPosition(place);
  int what = i % 7;
  if (what < 2) return askedOfLine(i);
  if (what == 2) {
    vec4 velocity = vec4(somePlace(i, 9), float(someOf(i, 10, 3) - 1));
    Motion m = advance(at, here, velocity, somePlace(i, 11), i % 2 == 0, i % 3 == 0, i % 5 == 0, i % 4 == 0, false, false);
    return i % 8 < 4 ? vec4(m.position, m.velocity.x) : vec4(m.velocity, isLost(m) ? 1.0f : 0.0f);
  }
  if (what == 3) {
    vec4 other = loadPosition(neighbour(at, 1, 0));
    float scaled = i % 2 == 0 ? scaledCompliance(i % 3) : fabricCompliance(i % 3 == 0, i % 4);
    float kept = keptStretch(here, other, springLength(i % 3));
    return vec4(constraintShift(here, other, springLength(i % 3), scaled, kept), kept);
  }
  if (what == 4) {
    Settled s = settled(loadPosition((place + 1) % 20), here, somePlace(i, 12), somePlace(i, 13), false, false);
    precise vec3 sum = s.motion.position + 2.0f * s.motion.velocity + 4.0f * s.trend;
    return vec4(sum, s.motion.velocity.y);
  }
  if (what == 5) {
    Motion m = i % 2 == 0 ? forced(loadPosition((place + 1) % 20), here, somePlace(i, 14), false, false)
                          : settledAgain(here, loadPosition((place + 1) % 20), i % 3 == 0 ? loadPosition((place + 1) % 20) : here,
                                         somePlace(i, 14), false, false);
    return i % 4 < 2 ? vec4(m.position, m.velocity.x) : vec4(m.velocity, m.position.x);
  }
  Corner a = cornerOf(here, vec4(somePlace(i, 15), 0.0f), vec4(somePlace(i, 16), 0.0f));
  Corner b = cornerOf(loadPosition(neighbour(at, 1, 0)), vec4(somePlace(i, 17), 0.0f), vec4(somePlace(i, 18), 0.0f));
  Corner c = cornerOf(loadPosition(neighbour(at, 0, 1)), vec4(somePlace(i, 19), 0.0f), vec4(somePlace(i, 20), 0.0f));
  ThinPush maximum = pushedByEdge(notPushed(), 0, a, b);
  maximum = pushedByFace(maximum, i % 2, a, b, c);
  maximum = together(maximum, pushedByEdge(notPushed(), 1, a, c));
  return i % 4 < 2 ? vec4(maximum.shift, maximum.squared) : vec4(maximum.change, mayMeet(0, a) ? 1.0f : 0.0f);
}

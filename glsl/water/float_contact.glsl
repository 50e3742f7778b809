// Contact between floating bodies. Compiles as GLSL and as C++, after water/float_model.glsl, with the same
// requirements.
//
// A body's shape is a sphere, or a lattice of signed distances, plus probes distributed over the surface
// (src/sim/water/float_shape.hpp). All probes of either body that lie inside the other form a single contact: its
// position and normal are the means weighted by depth, its depth is the maximum. Probes that can come inside within the
// step also count, so that no penetration is needed. Both bodies compute the same contact with the same bits, so their
// forces are equal and opposite.
//
//   J = max(0, (out - n.v) / (n.K n)),   K_n = sum of 1 / m + n.((I^-1 (r x n)) x r) over both bodies,   |J_t| <= mu J
//
// v is the relative velocity at the contact; there is no bounce. `out` is the speed that separates a penetration
// slowly, or that closes the gap in one step.

struct FloatMeet {
  // xyz contact position relative to the first body's centre, multiplied by the weight (m^2); w weight: depth plus
  // margin (m)
  vec4 place;
  vec4 way;    // xyz normal towards the first body, multiplied by the weight (m); w maximum depth (m)
};

FUNCTION FloatMeet floatApart() {
  FloatMeet meet;
  meet.place = vec4(0.0f);
  meet.way = vec4(0.0f, 0.0f, 0.0f, -1e9f);
  return meet;
}

FUNCTION FloatMeet floatMet(FloatMeet a, FloatMeet b) {
  precise vec4 place = a.place + b.place;
  precise vec3 way = vec3(a.way) + vec3(b.way);
  FloatMeet meet;
  meet.place = place;
  meet.way = vec4(way, max(a.way.w, b.way.w));
  return meet;
}

// Returns the second body, moved to its periodic image that is nearest to the first body.
FUNCTION FloatBody floatBeside(FloatBody first, FloatBody second) {
  precise vec3 separation = second.at - first.at;
  precise float wholeX = 2.0f * floats.halfX;
  precise float wholeZ = 2.0f * floats.halfZ;
  precise float lowerX = second.at.x - wholeX;
  precise float higherX = second.at.x + wholeX;
  precise float lowerZ = second.at.z - wholeZ;
  precise float higherZ = second.at.z + wholeZ;
  FloatBody beside = second;
  if (floats.west == periodicEdge)
    beside.at.x = separation.x > floats.halfX ? lowerX : separation.x < -floats.halfX ? higherX : second.at.x;
  if (floats.north == periodicEdge)
    beside.at.z = separation.z > floats.halfZ ? lowerZ : separation.z < -floats.halfZ ? higherZ : second.at.z;
  return beside;
}

// Returns the maximum distance in metres by which the bodies can approach each other in a step.
FUNCTION float floatMargin(FloatBody first, FloatBody second) {
  precise vec3 speed = first.velocity - second.velocity;
  precise float margin = floats.dt * exactSqrt(exactDot(speed, speed));
  return margin;
}

// Returns true if the bounding spheres of the bodies can touch in this step.
FUNCTION bool floatNear(FloatBody first, FloatParameters a, FloatBody second, FloatParameters b) {
  precise vec3 separation = second.at - first.at;
  precise float reach = a.mass.z + b.mass.z + floatMargin(first, second);
  precise float square = reach * reach;
  return exactDot(separation, separation) < square;
}

FUNCTION vec4 floatBetween(vec4 a, vec4 b, float part) {
  precise vec4 mean = a + (b - a) * part;
  return mean;
}

FUNCTION vec4 floatNodes(int i, int row, float partX, float partY) {
  vec4 upper = floatBetween(loadFloatPoint(i), loadFloatPoint(i + 1), partX);
  vec4 lower = floatBetween(loadFloatPoint(i + row), loadFloatPoint(i + row + 1), partX);
  return floatBetween(upper, lower, partY);
}

// Returns the normal (xyz) and the signed distance (w) of a body's shape at a point in the body's local space.
FUNCTION vec4 floatDistance(FloatParameters t, vec3 q) {
  if (t.meet.w > 0.0f) {
    float square = exactDot(q, q);
    float inverse = exactInverseSqrt(max(square, 1e-12f));
    precise vec3 normal = q * inverse;
    precise float off = square * inverse - t.meet.w;
    return vec4(normal, off);
  }
  precise vec3 u = (q - vec3(t.field)) * t.field.w;
  precise vec3 maximum = vec3(t.nodes) - 1.0f;
  vec3 held = min(max(u, vec3(0.0f)), maximum);
  precise vec3 last = maximum - 1.0f;
  vec3 whole = min(floor(held), last);
  precise vec3 part = held - whole;
  int across = int(t.nodes.x);
  int layer = across * int(t.nodes.y);
  int i = int(t.meet.z) + int(whole.z) * layer + int(whole.y) * across + int(whole.x);
  vec4 found = floatBetween(floatNodes(i, across, part.x, part.y), floatNodes(i + layer, across, part.x, part.y), part.z);
  vec3 slope = vec3(found);
  precise vec3 normal = slope * exactInverseSqrt(max(exactDot(slope, slope), 1e-12f));
  // Outside the lattice, `from` is the vector to q from the surface point that belongs to the nearest lattice point.
  precise vec3 beyond = (u - held) * t.nodes.w;
  precise vec3 from = beyond + found.w * normal;
  float square = exactDot(from, from);
  float inverse = exactInverseSqrt(max(square, 1e-12f));
  precise vec3 farNormal = from * inverse;
  precise float farOff = square * inverse;
  return exactDot(beyond, beyond) > 0.0f ? vec4(farNormal, farOff) : vec4(normal, found.w);
}

// Tests a probe of the body `owner` against the other body. `sign` is 1 if `owner` is the first body, otherwise -1.
FUNCTION FloatMeet floatProbe(vec4 probe, FloatBody owner, FloatBody other, FloatParameters o, vec3 origin, float sign, float margin) {
  precise vec3 place = owner.at + floatTurned(owner.turn, vec3(probe));
  precise vec3 across = place - other.at;
  vec4 seen = floatDistance(o, floatTurnedBack(other.turn, across));
  vec3 normal = floatTurned(other.turn, vec3(seen));
  precise float within = probe.w - seen.w;
  precise float weight = within + margin;
  float deep = weight > 1e-6f ? weight : 0.0f;
  precise float back = 0.5f * within - probe.w;
  precise vec3 contact = (place - origin) + back * normal;
  precise vec3 places = contact * deep;
  precise vec3 ways = normal * (sign * deep);
  FloatMeet meet;
  meet.place = vec4(places, deep);
  meet.way = vec4(ways, deep > 0.0f ? within : -1e9f);
  return meet;
}

// Sums the contributions of one lane's probes in a fixed order: the first body's probes, then the second body's probes.
FUNCTION FloatMeet floatMeetLane(int lane, FloatBody first, FloatParameters a, FloatBody second, FloatParameters b) {
  FloatMeet meet = floatApart();
  float margin = floatMargin(first, second);
  for (int i = int(a.meet.x) + lane; i < int(a.meet.y); i += floatLanes)
    meet = floatMet(meet, floatProbe(loadFloatPoint(i), first, second, b, first.at, 1.0f, margin));
  for (int i = int(b.meet.x) + lane; i < int(b.meet.y); i += floatLanes)
    meet = floatMet(meet, floatProbe(loadFloatPoint(i), second, first, a, first.at, -1.0f, margin));
  return meet;
}

// Returns the velocity along n (m/s), at the point `arm` relative to the centre, that is caused by an impulse of 1 kg
// m/s along n at this point.
FUNCTION float floatGive(FloatBody body, FloatParameters t, vec3 arm, vec3 n) {
  vec3 turned = floatTurning(t, body.turn, exactCross(arm, n));
  vec3 moved = exactCross(turned, arm);
  precise float give = t.mass.y + exactDot(moved, n);
  return give;
}

FUNCTION vec3 floatSpeedAt(FloatBody body, FloatParameters t, vec3 arm) {
  vec3 turning = floatTurning(t, body.turn, body.spin);
  precise vec3 speed = body.velocity + exactCross(turning, arm);
  return speed;
}

// Returns the contact force (N) on the first body.
FUNCTION vec3 floatPushed(FloatMeet meet, FloatBody first, FloatParameters a, FloatBody second, FloatParameters b) {
  float perDepth = exactReciprocal(max(meet.place.w, 1e-12f));
  precise vec3 arm = vec3(meet.place) * perDepth;
  precise vec3 otherArm = arm + (first.at - second.at);
  vec3 way = vec3(meet.way);
  precise vec3 normal = way * exactInverseSqrt(max(exactDot(way, way), 1e-24f));
  float deep = meet.way.w;
  precise vec3 speed = floatSpeedAt(first, a, arm) - floatSpeedAt(second, b, otherArm);
  float into = exactDot(speed, normal);
  precise float perStep = floats.damp * 2.5f;  // The damping rate is 0.4 / dt, so perStep is 1 / dt.
  precise float slowly = floatOut * min(deep, floats.deepest);
  float goes = deep > 0.0f ? slowly : deep;
  precise float separation = goes * perStep - into;
  precise float give = floatGive(first, a, arm, normal) + floatGive(second, b, otherArm, normal);
  precise float push = floatEase * max(separation, 0.0f) * exactReciprocal(max(give, 1e-30f));
  precise vec3 slide = speed - into * normal;
  float square = exactDot(slide, slide);
  float inverse = exactInverseSqrt(max(square, 1e-12f));
  precise vec3 along = slide * inverse;
  precise float slip = floatEase * square * inverse;
  precise float giveAlong = floatGive(first, a, arm, along) + floatGive(second, b, otherArm, along);
  precise float rough = 0.5f * (a.reach.z + b.reach.z);
  precise float maximum = rough * push;
  precise float stop = slip * exactReciprocal(max(giveAlong, 1e-30f));
  float held = min(maximum, stop);
  precise vec3 force = (push * normal - held * along) * perStep;
  return meet.place.w > 0.0f ? force : vec3(0.0f);
}

// Adds the force of a contact, and its moment, to a body's sums.
FUNCTION FloatSum floatWithPush(FloatSum sum, FloatMeet meet, vec3 force, bool isFirst, FloatBody first, FloatBody second) {
  float perDepth = exactReciprocal(max(meet.place.w, 1e-12f));
  precise vec3 arm = vec3(meet.place) * perDepth;
  precise vec3 otherArm = arm + (first.at - second.at);
  vec3 lever = isFirst ? arm : otherArm;
  precise vec3 opposite = -force;
  vec3 own = isFirst ? force : opposite;
  precise vec3 push = vec3(sum.push) + own;
  precise vec3 turn = vec3(sum.turn) + exactCross(lever, own);
  FloatSum both = sum;
  both.push = vec4(push, sum.push.w);
  both.turn = vec4(turn, sum.turn.w);
  return both;
}

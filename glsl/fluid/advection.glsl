// How a flow carries itself along. Compiles as GLSL and as C++, within transport.glsl.
// Where what is at p now will be after dt. The flow has been pushed for half of it, so it is the mean velocity of what is
// here on its way.
FUNCTION vec2 wentTo(vec2 p, vec2 own) {
  precise vec2 end = p + own * stepData.dt;
  return heldPoint(end);
}

// Where what is at p then was before: the same way back, p - dt u(where it was).
FUNCTION vec2 cameFrom(vec2 p, vec2 own) {
  precise vec2 about = p - own * stepData.dt;
  vec2 velocity = velocityAt(heldPoint(about));
  precise vec2 start = p - velocity * stepData.dt;
  return heldPoint(start);
}

// The first of four nodes around a place between node `node` and the next one; they begin at `first`, and end at `count`.
FUNCTION int firstOfFour(int node, int first, int count, bool wraps) {
  return wraps ? node - 1 : clamp(node - 1, first, count - 3);
}

// On a torus a cell of the ring or beyond it.
FUNCTION vec4 flowBeyond(int x, int y) {
  int i = x < -1 ? x + size.x : x > size.x ? x - size.x : x;
  int j = y < -1 ? y + size.y : y > size.y ? y - size.y : y;
  return flowAt(i, j);
}

FUNCTION float cubicRow(int which, int x, int y, vec4 w) {
  precise float value = (w.x * partOf(flowBeyond(x, y), which) + w.y * partOf(flowBeyond(x + 1, y), which)) +
                        (w.z * partOf(flowBeyond(x + 2, y), which) + w.w * partOf(flowBeyond(x + 3, y), which));
  return value;
}

// By cubic polynomials along x and y, within the four values nearest.
FUNCTION float cubicAt(int which, vec2 p) {
  vec2 node = nodeOf(which, p);
  int x = firstOfFour(int(floor(node.x)), which == 0 ? 0 : -1, size.x, leftKind == periodicSide);
  int y = firstOfFour(int(floor(node.y)), which == 1 ? 0 : -1, size.y, topKind == periodicSide);
  precise float alongX = node.x - float(x);
  precise float alongY = node.y - float(y);
  vec4 wx = cubicWeights(alongX), wy = cubicWeights(alongY);
  precise float value = (wy.x * cubicRow(which, x, y, wx) + wy.y * cubicRow(which, x, y + 1, wx)) +
                        (wy.z * cubicRow(which, x, y + 2, wx) + wy.w * cubicRow(which, x, y + 3, wx));
  Around near = around(false, which, p);
  return clamp(value, min(min(near.a, near.b), min(near.c, near.d)), max(max(near.a, near.b), max(near.c, near.d)));
}

// Semi-Lagrangian: what was where this place's fluid comes from.
FUNCTION float carriedPart(int which, int x, int y) {
  vec2 from = cameFrom(placeOf(which, x, y), ownVelocity(which, x, y));
  return exactFlush(cubic ? cubicAt(which, from) : valueIn(around(false, which, from)));
}

// MacCormack: less half of what carrying it back again would miss; within the values that it came from.
FUNCTION float correctedPart(int which, int x, int y) {
  vec2 place = placeOf(which, x, y);
  vec2 own = ownVelocity(which, x, y);
  Around from = around(false, which, cameFrom(place, own));
  float there = valueIn(around(true, which, wentTo(place, own)));
  precise float value = partOf(carriedAt(x, y), which) + 0.5f * (partOf(flowAt(x, y), which) - there);
  float low = min(min(from.a, from.b), min(from.c, from.d));
  float high = max(max(from.a, from.b), max(from.c, from.d));
  return clamp(value, low, high);
}

FUNCTION float movedPart(int which, int x, int y) {
  return secondOrder ? correctedPart(which, x, y) : partOf(carriedAt(x, y), which);
}

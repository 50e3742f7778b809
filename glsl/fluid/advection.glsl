// Advection of the flow by itself. Compiles as GLSL and as C++ as part of transport.glsl.

// Returns where the fluid that is now at p will be at the end of the step. `own` is the velocity at p. The flow has
// already received half of the step's forces, so this velocity is the mean along the path.
FUNCTION vec2 destination(vec2 p, vec2 own) {
  precise vec2 end = p + own * stepData.dt;
  return heldPoint(end);
}

// Returns where the fluid that arrives at p was at the start of the step: p - dt u(p - dt own), where u is the flow and
// `own` the velocity at p.
FUNCTION vec2 departure(vec2 p, vec2 own) {
  precise vec2 about = p - own * stepData.dt;
  vec2 velocity = velocityAt(heldPoint(about));
  precise vec2 start = p - velocity * stepData.dt;
  return heldPoint(start);
}

// Returns the index of the first of the four interpolation nodes for a position between `node` and the next node. The
// node indices start at `first` and end before `count`; if `wraps` is true, the axis is periodic.
FUNCTION int firstOfFour(int node, int first, int count, bool wraps) {
  return wraps ? node - 1 : clamp(node - 1, first, count - 3);
}

// Returns the flow in a cell of a periodic grid. The cell may be up to one grid size outside the ring.
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

// Interpolates component `which` of the flow with cubic polynomials along x and y, clamped to the range of the four
// nearest values.
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

// Semi-Lagrangian advection: returns the value at the position from which the fluid of this cell comes.
FUNCTION float carriedPart(int which, int x, int y) {
  vec2 from = departure(placeOf(which, x, y), ownVelocity(which, x, y));
  return exactFlush(cubic ? cubicAt(which, from) : valueIn(around(false, which, from)));
}

// MacCormack advection: subtracts half of the error that remains after advecting forwards and back again. The result is
// clamped to the range of the four values around the position from which the fluid comes.
FUNCTION float correctedPart(int which, int x, int y) {
  vec2 place = placeOf(which, x, y);
  vec2 own = ownVelocity(which, x, y);
  Around from = around(false, which, departure(place, own));
  float there = valueIn(around(true, which, destination(place, own)));
  precise float value = partOf(carriedAt(x, y), which) + 0.5f * (partOf(flowAt(x, y), which) - there);
  float low = min(min(from.a, from.b), min(from.c, from.d));
  float high = max(max(from.a, from.b), max(from.c, from.d));
  return clamp(value, low, high);
}

FUNCTION float movedPart(int which, int x, int y) {
  return secondOrder ? correctedPart(which, x, y) : partOf(carriedAt(x, y), which);
}

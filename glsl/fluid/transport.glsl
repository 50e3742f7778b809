// How a fluid's cells change in a step, but for the pressure's solution. Compiles as GLSL (grid.glsl) and as C++, in a
// struct that has what is read: flowAt, carriedAt, dyeAt, faceAt, sumAt, size, stepData and the kinds of the sides.
//
// Cell (x, y) holds u in the middle of its left face, v in that of its top face, temperature and pressure in its own. Around
// the grid lies a ring of cells, so x is from -1 to size.x: beyond walls u and v are mirrored, so that the mean is the
// wall's. u at size.x and v at size.y are faces of the border.

FUNCTION int insideX(int x) {
  if (leftKind == periodicSide) return x < 0 ? x + size.x : x >= size.x ? x - size.x : x;
  return clamp(x, 0, size.x - 1);
}

FUNCTION int insideY(int y) {
  if (topKind == periodicSide) return y < 0 ? y + size.y : y >= size.y ? y - size.y : y;
  return clamp(y, 0, size.y - 1);
}

// Of faces across x: there is one more of them.
FUNCTION int faceX(int x) {
  return leftKind == periodicSide ? insideX(x) : clamp(x, 0, size.x);
}

FUNCTION int faceY(int y) {
  return topKind == periodicSide ? insideY(y) : clamp(y, 0, size.y);
}

FUNCTION bool mirrors(int kind) {
  return kind == wallSide || kind == inflowSide;
}

FUNCTION float mirrored(float inside, float wall) {
  precise float value = 2.0f * wall - inside;
  return value;
}

// u of a row beyond top or bottom, given that of the row within.
FUNCTION float beyondTopBottom(float u, int y) {
  float value = u;
  if (y < 0 && mirrors(topKind)) value = mirrored(u, stepData.topBottom.x);
  if (y >= size.y && mirrors(bottomKind)) value = mirrored(u, stepData.topBottom.z);
  return value;
}

FUNCTION float beyondLeftRight(float v, int x) {
  float value = v;
  if (x < 0 && mirrors(leftKind)) value = mirrored(v, stepData.leftRight.y);
  if (x >= size.x && mirrors(rightKind)) value = mirrored(v, stepData.leftRight.w);
  return value;
}

// Whether a cell of the ring lies beyond an open side: there is no pressure and no dye.
FUNCTION bool beyondOpen(int x, int y) {
  return (x < 0 && leftKind == openSide) || (x >= size.x && rightKind == openSide) || (y < 0 && topKind == openSide) ||
         (y >= size.y && bottomKind == openSide);
}

FUNCTION float heldAlong(float p, float end, bool wraps) {
  precise float after = p + end;
  precise float before = p - end;
  float turned = p < 0.0f ? after : p >= end ? before : p;
  return clamp(wraps ? turned : p, 0.0f, end);
}

FUNCTION vec2 heldPoint(vec2 p) {
  return vec2(heldAlong(p.x, float(size.x), leftKind == periodicSide), heldAlong(p.y, float(size.y), topKind == periodicSide));
}

// The values around a point, and how far it lies between them.
struct Around {
  float a, b, c, d;
  float x, y;
};

FUNCTION float valueIn(Around s) {
  return between(between(s.a, s.b, s.x), between(s.c, s.d, s.x), s.y);
}

// Component `which` of a cell: 0 u, 1 v, 2 temperature.
FUNCTION float partOf(vec4 cell, int which) {
  return which == 0 ? cell.x : which == 1 ? cell.y : cell.z;
}

FUNCTION vec2 nodeOf(int which, vec2 p) {
  precise float x = which == 0 ? p.x : p.x - 0.5f;
  precise float y = which == 1 ? p.y : p.y - 0.5f;
  return vec2(x, y);
}

FUNCTION Around around(bool ofCarried, int which, vec2 p) {
  vec2 node = nodeOf(which, p);
  int x = min(int(floor(node.x)), size.x - 1);
  int y = min(int(floor(node.y)), size.y - 1);
  precise float fx = node.x - float(x);
  precise float fy = node.y - float(y);
  Around s;
  s.a = partOf(ofCarried ? carriedAt(x, y) : flowAt(x, y), which);
  s.b = partOf(ofCarried ? carriedAt(x + 1, y) : flowAt(x + 1, y), which);
  s.c = partOf(ofCarried ? carriedAt(x, y + 1) : flowAt(x, y + 1), which);
  s.d = partOf(ofCarried ? carriedAt(x + 1, y + 1) : flowAt(x + 1, y + 1), which);
  s.x = fx;
  s.y = fy;
  return s;
}

FUNCTION vec2 velocityAt(vec2 p) {
  return vec2(valueIn(around(false, 0, p)), valueIn(around(false, 1, p)));
}

// Of a component's own place in a cell.
FUNCTION vec2 ownVelocity(int which, int x, int y) {
  vec4 here = flowAt(x, y);
  if (which == 0) {
    vec4 before = flowAt(x - 1, y);
    vec4 belowBefore = flowAt(x - 1, y + 1);
    vec4 below = flowAt(x, y + 1);
    precise float v = 0.25f * ((before.y + here.y) + (belowBefore.y + below.y));
    return vec2(here.x, v);
  }
  vec4 after = flowAt(x + 1, y);
  if (which == 1) {
    vec4 above = flowAt(x, y - 1);
    vec4 aboveAfter = flowAt(x + 1, y - 1);
    precise float u = 0.25f * ((above.x + aboveAfter.x) + (here.x + after.x));
    return vec2(u, here.y);
  }
  vec4 under = flowAt(x, y + 1);
  precise float middleU = 0.5f * (here.x + after.x);
  precise float middleV = 0.5f * (here.y + under.y);
  return vec2(middleU, middleV);
}

FUNCTION vec2 placeOf(int which, int x, int y) {
  precise float px = which == 0 ? float(x) : float(x) + 0.5f;
  precise float py = which == 1 ? float(y) : float(y) + 0.5f;
  return vec2(px, py);
}

// Where what is at p now will be in `seconds`, or was: by the velocity half-way, which is second-order.
FUNCTION vec2 traced(vec2 p, vec2 own, float seconds) {
  precise vec2 half_ = p + own * (0.5f * seconds);
  vec2 velocity = velocityAt(heldPoint(half_));
  precise vec2 end = p + velocity * seconds;
  return heldPoint(end);
}

// Semi-Lagrangian: what was where this place's fluid comes from.
FUNCTION float carriedPart(int which, int x, int y) {
  vec2 from = traced(placeOf(which, x, y), ownVelocity(which, x, y), -stepData.dt);
  return exactFlush(valueIn(around(false, which, from)));
}

// MacCormack: less half of what carrying it back again would miss; within the values that it came from.
FUNCTION float correctedPart(int which, int x, int y) {
  vec2 place = placeOf(which, x, y);
  vec2 own = ownVelocity(which, x, y);
  Around from = around(false, which, traced(place, own, -stepData.dt));
  float there = valueIn(around(true, which, traced(place, own, stepData.dt)));
  precise float value = partOf(carriedAt(x, y), which) + 0.5f * (partOf(flowAt(x, y), which) - there);
  float low = min(min(from.a, from.b), min(from.c, from.d));
  float high = max(max(from.a, from.b), max(from.c, from.d));
  return clamp(value, low, high);
}

FUNCTION float movedPart(int which, int x, int y) {
  return secondOrder ? correctedPart(which, x, y) : partOf(carriedAt(x, y), which);
}

// dv/dx - du/dy at the upper left corner of a cell.
FUNCTION float curlAt(int x, int y) {
  int i = leftKind == periodicSide ? insideX(x) : clamp(x, 0, size.x);
  int j = topKind == periodicSide ? insideY(y) : clamp(y, 0, size.y);
  vec4 here = flowAt(i, j);
  precise float curl = (here.y - flowAt(i - 1, j).y) - (here.x - flowAt(i, j - 1).x);
  return curl;
}

FUNCTION float meanCurl(float a, float b) {
  precise float mean = 0.5f * (a + b);
  return mean;
}

// Vorticity confinement, dt epsilon N x omega with N the unit vector up the slope of |omega|: along x at the middle of a
// left face, along y at that of a top face.
FUNCTION float confinementX(int x, int y) {
  float top = curlAt(x, y);
  float bottom = curlAt(x, y + 1);
  precise float sides = 0.25f * ((abs(curlAt(x + 1, y)) + abs(curlAt(x + 1, y + 1))) -
                                 (abs(curlAt(x - 1, y)) + abs(curlAt(x - 1, y + 1))));
  precise float along = abs(bottom) - abs(top);
  precise float length2 = sides * sides + along * along;
  precise float force = stepData.confinement * meanCurl(top, bottom) * along * exactInverseSqrt(max(length2, 1e-12f));
  return force;
}

FUNCTION float confinementY(int x, int y) {
  float left = curlAt(x, y);
  float right = curlAt(x + 1, y);
  precise float sides = 0.25f * ((abs(curlAt(x, y + 1)) + abs(curlAt(x + 1, y + 1))) -
                                 (abs(curlAt(x, y - 1)) + abs(curlAt(x + 1, y - 1))));
  precise float along = abs(right) - abs(left);
  precise float length2 = sides * sides + along * along;
  precise float force = stepData.confinement * meanCurl(left, right) * along * exactInverseSqrt(max(length2, 1e-12f));
  return -force;
}

FUNCTION float laplacianOf(float here, float left, float right, float top, float bottom) {
  precise float sum = ((left + right) + (top + bottom)) - 4.0f * here;
  return sum;
}

// Friction and confinement come before the flow carries itself along, for they act where the fluid is, which may be cells
// away from where it goes.
FUNCTION float rubbedU(int x, int y) {
  float here = flowAt(x, y).x;
  float pull = laplacianOf(here, flowAt(max(x - 1, -1), y).x, flowAt(min(x + 1, size.x), y).x, flowAt(x, y - 1).x,
                           flowAt(x, y + 1).x);
  float spin = confines ? confinementX(x, y) : 0.0f;
  precise float value = here + (stepData.viscosity * pull + spin);
  return faceAt(x, y).x == 0.0f ? here : exactFlush(value);
}

FUNCTION float rubbedV(int x, int y) {
  float here = flowAt(x, y).y;
  float pull = laplacianOf(here, flowAt(x - 1, y).y, flowAt(x + 1, y).y, flowAt(x, max(y - 1, -1)).y,
                           flowAt(x, min(y + 1, size.y)).y);
  float spin = confines ? confinementY(x, y) : 0.0f;
  precise float value = here + (stepData.viscosity * pull + spin);
  return faceAt(x, y).y == 0.0f ? here : exactFlush(value);
}

// u of a left face before the pressure makes the flow free of divergence.
FUNCTION float steppedU(int x, int y) {
  float here = flowAt(x, y).x;
  float open = faceAt(x, y).x;
  bool atLeft = x == 0 && leftKind != periodicSide;
  bool atRight = x == size.x && leftKind != periodicSide;
  if (open == 0.0f) return atLeft ? stepData.leftRight.x : atRight ? stepData.leftRight.z : here;
  precise float push = stepData.dt * (open * (flowAt(x, y).w - flowAt(x - 1, y).w));
  precise float value = movedPart(0, x, y) - push;
  return exactFlush(value);
}

FUNCTION float densityOf(vec4 dye) {
  precise float sum = (dye.x + dye.y) + dye.z;
  return sum;
}

FUNCTION float steppedV(int x, int y) {
  float here = flowAt(x, y).y;
  float open = faceAt(x, y).y;
  bool atTop = y == 0 && topKind != periodicSide;
  bool atBottom = y == size.y && topKind != periodicSide;
  if (open == 0.0f) return atTop ? stepData.topBottom.y : atBottom ? stepData.topBottom.w : here;
  precise float push = stepData.dt * (open * (flowAt(x, y).w - flowAt(x, y - 1).w));
  precise float value = movedPart(1, x, y) - push;
  if (heats) {
    precise float upwards = 0.5f * stepData.lift * (flowAt(x, y).z + flowAt(x, y - 1).z);
    value = value - upwards;
  }
  if (sinks) {
    precise float fall = 0.166666667f * stepData.weight * (densityOf(dyeAt(x, y)) + densityOf(dyeAt(x, y - 1)));
    value = value + fall;
  }
  return exactFlush(value);
}

FUNCTION float steppedHeat(int x, int y) {
  precise float value = movedPart(2, x, y) * stepData.keptHeat;
  return exactFlush(value);
}

// What a kernel writes for a cell of the grid or of the ring around it.
FUNCTION vec4 carriedCell(int x, int y) {
  int fx = faceX(x), fy = faceY(y), ix = insideX(x), iy = insideY(y);
  float u = faceAt(fx, iy).x == 0.0f ? flowAt(fx, iy).x : carriedPart(0, fx, iy);
  float v = faceAt(ix, fy).y == 0.0f ? flowAt(ix, fy).y : carriedPart(1, ix, fy);
  float heat = heats ? carriedPart(2, ix, iy) : 0.0f;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), heat, 0.0f);
}

FUNCTION vec4 rubbedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = rubbedU(faceX(x), iy);
  float v = rubbedV(ix, faceY(y));
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), flowAt(x, y).z, flowAt(x, y).w);
}

FUNCTION vec4 steppedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = steppedU(faceX(x), iy);
  float v = steppedV(ix, faceY(y));
  float heat = heats ? steppedHeat(ix, iy) : 0.0f;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), heat, flowAt(ix, iy).w);
}

// sumAt: the sum of all corrections phi of the pressure, and what rounding took from it; u' = u - grad phi.
FUNCTION float rise(vec2 from, vec2 to) {
  precise float difference = (to.x - from.x) + (to.y - from.y);
  return difference;
}

FUNCTION float projectedU(int x, int y) {
  precise float value = flowAt(x, y).x - faceAt(x, y).x * rise(sumAt(x - 1, y), sumAt(x, y));
  return exactFlush(value);
}

FUNCTION float projectedV(int x, int y) {
  precise float value = flowAt(x, y).y - faceAt(x, y).y * rise(sumAt(x, y - 1), sumAt(x, y));
  return exactFlush(value);
}

FUNCTION bool isSolid(int x, int y) {
  vec2 here = faceAt(x, y);
  return here.x == 0.0f && here.y == 0.0f && faceAt(x + 1, y).x == 0.0f && faceAt(x, y + 1).y == 0.0f;
}

// Along a wall within an obstacle: mirrored, so that the wall has speed 0 half-way, or the same where it slips.
FUNCTION float withinObstacle(bool first, float one, bool second, float other) {
  precise float both = 0.5f * (one + other);
  float mean = first ? (second ? both : one) : second ? other : 0.0f;
  return obstaclesSlip ? mean : -mean;
}

FUNCTION float finishedU(int x, int y) {
  if (faceAt(x, y).x > 0.0f) return projectedU(x, y);
  bool border = leftKind != periodicSide && (x == 0 || x == size.x);
  if (border) return flowAt(x, y).x;
  if (!isSolid(insideX(x), y) || !isSolid(insideX(x - 1), y)) return 0.0f;
  int above = insideY(y - 1), below = insideY(y + 1);
  return withinObstacle(faceAt(x, above).x > 0.0f, projectedU(x, above), faceAt(x, below).x > 0.0f, projectedU(x, below));
}

FUNCTION float finishedV(int x, int y) {
  if (faceAt(x, y).y > 0.0f) return projectedV(x, y);
  bool border = topKind != periodicSide && (y == 0 || y == size.y);
  if (border) return flowAt(x, y).y;
  if (!isSolid(x, insideY(y)) || !isSolid(x, insideY(y - 1))) return 0.0f;
  int left = insideX(x - 1), right = insideX(x + 1);
  return withinObstacle(faceAt(left, y).y > 0.0f, projectedV(left, y), faceAt(right, y).y > 0.0f, projectedV(right, y));
}

FUNCTION vec4 finishedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = finishedU(faceX(x), iy);
  float v = finishedV(ix, faceY(y));
  vec4 inside = flowAt(ix, iy);
  vec2 sum = sumAt(ix, iy);
  precise float pressure = inside.w + stepData.perDt * (sum.x + sum.y);
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), inside.z, beyondOpen(x, y) ? 0.0f : exactFlush(pressure));
}

// Minus the net flow out of a cell: what the corrections have to take away.
FUNCTION float missingFlow(int x, int y) {
  vec4 here = flowAt(x, y);
  precise float out_ = (flowAt(x + 1, y).x - here.x) + (flowAt(x, y + 1).y - here.y);
  return isSolid(x, y) ? 0.0f : -out_;
}

FUNCTION float dyeWay(float speed) {
  precise float way = speed * stepData.dyeDt;
  return clamp(way, -maxDyeWay, maxDyeWay);
}

FUNCTION vec4 dyeThroughLeft(int x, int y) {
  return dyeFluxes(dyeWay(flowAt(x, y).x), dyeAt(x - 2, y), dyeAt(x - 1, y), dyeAt(x, y), dyeAt(x + 1, y));
}

FUNCTION vec4 dyeThroughTop(int x, int y) {
  return dyeFluxes(dyeWay(flowAt(x, y).y), dyeAt(x, y - 2), dyeAt(x, y - 1), dyeAt(x, y), dyeAt(x, y + 1));
}

FUNCTION vec4 dyedCell(int x, int y) {
  if (beyondOpen(x, y)) return vec4(0.0f);
  int ix = insideX(x), iy = insideY(y);
  precise vec4 next = dyeAt(ix, iy) - ((dyeThroughLeft(ix + 1, iy) - dyeThroughLeft(ix, iy)) +
                                       (dyeThroughTop(ix, iy + 1) - dyeThroughTop(ix, iy)));
  return next;
}

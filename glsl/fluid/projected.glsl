// Effect of the pressure correction phi on the flow u: u' = u - grad phi. Compiles as GLSL and as C++, after
// transport.glsl. sumAt() returns the sum phi of all corrections and the rounding error of the sum.

// Returns the slope of phi between two cells that are one cell apart. At a border the distance is half a cell, so the
// slope is twice the difference.
FUNCTION float rise(vec2 from, vec2 to, bool border) {
  precise float difference = (to.x - from.x) + (to.y - from.y);
  precise float twice = difference + difference;
  return border ? twice : difference;
}

FUNCTION float projectedU(int x, int y) {
  float u = flowAt(x, y).x;
  if (faceAt(x, y).x == 0.0f) return u;
  precise float value = u - rise(sumAt(x - 1, y), sumAt(x, y), borderU(x));
  return exactFlush(value);
}

FUNCTION float projectedV(int x, int y) {
  float v = flowAt(x, y).y;
  if (faceAt(x, y).y == 0.0f) return v;
  precise float value = v - rise(sumAt(x, y - 1), sumAt(x, y), borderV(y));
  return exactFlush(value);
}

FUNCTION bool isSolid(int x, int y) {
  vec2 here = faceAt(x, y);
  return here.x == 0.0f && here.y == 0.0f && faceAt(x + 1, y).x == 0.0f && faceAt(x, y + 1).y == 0.0f;
}

// Returns the fraction of a cell's area that is fluid.
FUNCTION float openPart(int x, int y) {
  precise float part = 0.5f + offWall(x, y);
  return isSolid(x, y) ? 0.0f : obstacles ? clamp(part, 0.0f, 1.0f) : 1.0f;
}

FUNCTION float pressureThen(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  vec2 sum = sumAt(ix, iy);
  precise float pressure = flowAt(ix, iy).w + stepData.perDt * (sum.x + sum.y);
  return pressure;
}

// Returns component `which` of the projected flow at a node, which may be in the ring: 0 is u, 1 is v, 2 is the
// pressure.
FUNCTION float projectedComponent(int which, int x, int y) {
  if (which == 0) return beyondTopBottom(projectedU(faceX(x), insideY(y)), y);
  if (which == 1) return beyondLeftRight(projectedV(insideX(x), faceY(y)), x);
  return pressureThen(x, y);
}

FUNCTION float seenThen(int which, vec2 p) {
  vec2 node = nodeOf(which, p);
  int x = min(int(floor(node.x)), size.x - 1);
  int y = min(int(floor(node.y)), size.y - 1);
  precise float fx = node.x - float(x);
  precise float fy = node.y - float(y);
  float upper = between(projectedComponent(which, x, y), projectedComponent(which, x + 1, y), fx);
  float lower = between(projectedComponent(which, x, y + 1), projectedComponent(which, x + 1, y + 1), fx);
  return between(upper, lower, fy);
}

// Return the velocity of a face after the projection. Closed faces inside obstacles get the velocity that makes the
// adjacent fluid stick to the wall (no slip) or slide along it (slip).
FUNCTION float finishedU(int x, int y) {
  if (!obstacles || faceAt(x, y).x > 0.0f || borderU(x)) return projectedU(x, y);
  if (offWallU(x, y) < deepWall) return solidU(x, y);
  vec2 from = seenFromU(x, y);
  return exactFlush(wallU(x, y, from, seenThen(0, from)));
}

FUNCTION float finishedV(int x, int y) {
  if (!obstacles || faceAt(x, y).y > 0.0f || borderV(y)) return projectedV(x, y);
  if (offWallV(x, y) < deepWall) return solidV(x, y);
  vec2 from = seenFromV(x, y);
  return exactFlush(wallV(x, y, from, seenThen(1, from)));
}

// Returns the final values of a cell. Inside obstacles, temperature and pressure are copied from the fluid outside the
// wall. The wall therefore conducts nothing, and a cell that becomes free has suitable values.
FUNCTION vec4 finishedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = finishedU(faceX(x), iy);
  float v = finishedV(ix, faceY(y));
  float heat = flowAt(ix, iy).z;
  float pressure = pressureThen(ix, iy);
  if (obstacles && isSolid(ix, iy) && offWall(ix, iy) > deepWall) {
    if (heats) heat = valueIn(around(false, 2, seenFromCell(ix, iy)));
    if (obstaclesMove) pressure = seenThen(2, seenFromCell(ix, iy));
  }
  bool beyond = beyondOpen(x, y);
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), beyond ? 0.0f : exactFlush(heat),
              beyond ? 0.0f : exactFlush(pressure));
}

FUNCTION float throughThenU(int x, int y) {
  float weight = faceAt(x, y).x;
  return through(weight, borderU(x), projectedU(x, y), weight < 1.0f ? solidU(x, y) : 0.0f);
}

FUNCTION float throughThenV(int x, int y) {
  float weight = faceAt(x, y).y;
  return through(weight, borderV(y), projectedV(x, y), weight < 1.0f ? solidV(x, y) : 0.0f);
}

// Returns the required net outflow of a cell: 0, except in a closed pocket whose walls move.
FUNCTION float growthAt(int x, int y) {
  if (!pocketsGrow) return 0.0f;
  int pocket = int(solidWord(x, y) >> 24u);
  vec4 four = solidSet.growth[pocket >> 2];
  float of = (pocket & 2) == 0 ? ((pocket & 1) == 0 ? four.x : four.y) : ((pocket & 1) == 0 ? four.z : four.w);
  float part = openPart(x, y);
  precise float growth = of * part;
  return growth;
}

// Returns the excess inflow of a cell (the negative divergence), which the pressure correction must remove.
FUNCTION float missingFlow(int x, int y) {
  precise float out_ = (throughU(x + 1, y) - throughU(x, y)) + (throughV(x, y + 1) - throughV(x, y));
  precise float missing = growthAt(x, y) - out_;
  return isSolid(x, y) ? 0.0f : missing;
}

// Returns the excess inflow of a cell after the correction.
FUNCTION float stillMissing(int x, int y) {
  precise float out_ = (throughThenU(faceX(x + 1), y) - throughThenU(x, y)) +
                       (throughThenV(x, faceY(y + 1)) - throughThenV(x, y));
  precise float missing = growthAt(x, y) - out_;
  return isSolid(x, y) ? 0.0f : missing;
}

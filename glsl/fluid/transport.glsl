// How a fluid's cells change in a step, but for the pressure's solution. Compiles as GLSL (grid.glsl) and as C++, in a
// struct that has what is read: flowAt, carriedAt, dyeAt, faceAt, solidWord, sumAt, size, stepData, solidSet and the kinds
// of the sides.
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

// Faces of the border, where the middle beyond lies half a cell away if it lets anything through.
FUNCTION bool borderU(int x) {
  return leftKind != periodicSide && (x == 0 || x == size.x);
}

FUNCTION bool borderV(int y) {
  return topKind != periodicSide && (y == 0 || y == size.y);
}

// What u of the left and right sides is, v of top and bottom.
FUNCTION float sideU(int x, int y) {
  float speed = x == 0 ? stepData.leftRight.x : stepData.leftRight.z;
  return sideSpeed(y, size.y, speed, x == 0 ? stepData.parabolas.x : stepData.parabolas.y);
}

FUNCTION float sideV(int x, int y) {
  float speed = y == 0 ? stepData.topBottom.y : stepData.topBottom.w;
  return sideSpeed(x, size.x, speed, y == 0 ? stepData.parabolas.z : stepData.parabolas.w);
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
  float column = min(floor(node.x), float(size.x - 1)), row = min(floor(node.y), float(size.y - 1));
  precise float fx = node.x - column;
  precise float fy = node.y - row;
  int x = int(column), y = int(row);
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

#include "fluid/walls.glsl"

#include "fluid/advection.glsl"

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

// What there is of confinement's force: all up to half the speed that is expected, nothing from that speed on. The force grows
// with the flow that it drives, so nothing else would end it.
FUNCTION float confinedShare(int x, int y) {
  vec4 here = flowAt(x, y);
  float speed = max(abs(here.x), abs(here.y));
  precise float share = 2.0f - speed * stepData.confined.x;
  return clamp(share, 0.0f, 1.0f);
}

// Vorticity confinement, dt epsilon N x omega with N the unit vector up the slope of |omega|: along x at the middle of a
// left face, along y at that of a top face.
FUNCTION float confinementX(int x, int y) {
  float share = confinedShare(x, y);
  float top = curlAt(x, y);
  float bottom = curlAt(x, y + 1);
  precise float sides = 0.25f * ((abs(curlAt(x + 1, y)) + abs(curlAt(x + 1, y + 1))) -
                                 (abs(curlAt(x - 1, y)) + abs(curlAt(x - 1, y + 1))));
  precise float along = abs(bottom) - abs(top);
  precise float length2 = sides * sides + along * along;
  precise float force = stepData.confinement * meanCurl(top, bottom) * along * exactInverseSqrt(max(length2, 1e-12f)) * share;
  return force;
}

FUNCTION float confinementY(int x, int y) {
  float share = confinedShare(x, y);
  float left = curlAt(x, y);
  float right = curlAt(x + 1, y);
  precise float sides = 0.25f * ((abs(curlAt(x, y + 1)) + abs(curlAt(x + 1, y + 1))) -
                                 (abs(curlAt(x, y - 1)) + abs(curlAt(x + 1, y - 1))));
  precise float along = abs(right) - abs(left);
  precise float length2 = sides * sides + along * along;
  precise float force = stepData.confinement * meanCurl(left, right) * along * exactInverseSqrt(max(length2, 1e-12f)) * share;
  return -force;
}

FUNCTION float laplacianOf(float here, float left, float right, float top, float bottom) {
  precise float sum = ((left + right) + (top + bottom)) - 4.0f * here;
  return sum;
}

FUNCTION float partThere(bool ofCarried, int which, int x, int y) {
  return partOf(ofCarried ? carriedAt(x, y) : flowAt(x, y), which);
}

// What is missing of the second difference beside a wall, which is half a cell away and not a whole one, as the mirrored
// value `beyond` has it: 8/3 wall - 4 here + 4/3 after instead of 2 wall - 3 here + after.
FUNCTION float besideWall(float beyond, float here, float after) {
  precise float more = 0.333333333f * ((beyond + here) + after) - here;
  return more;
}

FUNCTION float pullOn(bool ofCarried, int which, int x, int y) {
  float here = partThere(ofCarried, which, x, y);
  float left = partThere(ofCarried, which, max(x - 1, -1), y), right = partThere(ofCarried, which, min(x + 1, size.x), y);
  float top = partThere(ofCarried, which, x, max(y - 1, -1)), bottom = partThere(ofCarried, which, x, min(y + 1, size.y));
  float first = 0.0f, second = 0.0f;
  if (which == 0) {
    if (y == 0 && mirrors(topKind)) first = besideWall(top, here, bottom);
    if (y == size.y - 1 && mirrors(bottomKind)) second = besideWall(bottom, here, top);
  } else {
    if (x == 0 && mirrors(leftKind)) first = besideWall(left, here, right);
    if (x == size.x - 1 && mirrors(rightKind)) second = besideWall(right, here, left);
  }
  precise float pull = laplacianOf(here, left, right, top, bottom) + (first + second);
  return pull;
}

// Half of what friction does in a step.
FUNCTION float frictionOn(bool ofCarried, int which, int x, int y) {
  if (!viscous) return 0.0f;
  precise float pull = 0.5f * stepData.viscosity * pullOn(ofCarried, which, x, y);
  return pull;
}

// How much of the pressure of the step before is taken for what this one's will be, where the fastest of the flow goes at
// `fastest` cells/s: all while it goes two cells in a step, nothing from three on. There vortices have turned on, what was carried
// off by the pressure's slope is elsewhere, and the flow would gain energy from it. With nothing it is Chorin's
// projection, which is of first order and stable however fast the flow is.
FUNCTION float keptPressure(float fastest) {
  precise float kept = 3.0f - fastest * stepData.dt;
  return clamp(kept, 0.0f, 1.0f);
}

// Half of what the forces do comes before the flow carries itself along, half after it: the trapezoid rule along the ways
// of the fluid, second-order in time. Confinement, which has no order, comes before.
FUNCTION float pushOnU(float kept, int x, int y) {
  precise float slope = kept * flowAt(x, y).w - kept * flowAt(x - 1, y).w;
  precise float push = (borderU(x) ? stepData.dt : 0.5f * stepData.dt) * slope;
  return push;
}

FUNCTION float pushOnV(bool ofCarried, float kept, int x, int y) {
  vec4 here = flowAt(x, y), above = flowAt(x, y - 1);
  precise float slope = kept * here.w - kept * above.w;
  precise float push = (borderV(y) ? stepData.dt : 0.5f * stepData.dt) * slope;
  if (heats) {
    float heat = ofCarried ? carriedAt(x, y).z : here.z, heatAbove = ofCarried ? carriedAt(x, y - 1).z : above.z;
    push = push + 0.25f * stepData.lift * (heat + heatAbove);
  }
  return push;
}

FUNCTION float pushedU(float kept, int x, int y) {
  float here = flowAt(x, y).x;
  if (faceAt(x, y).x == 0.0f || heldU(x, y)) return here;
  float spin = confines ? confinementX(x, y) : 0.0f;
  precise float value = here + ((frictionOn(false, 0, x, y) + spin) - pushOnU(kept, x, y));
  return exactFlush(value);
}

FUNCTION float pushedV(float kept, int x, int y) {
  float here = flowAt(x, y).y;
  if (faceAt(x, y).y == 0.0f || heldV(x, y)) return here;
  float spin = confines ? confinementY(x, y) : 0.0f;
  precise float value = here + ((frictionOn(false, 1, x, y) + spin) - pushOnV(false, kept, x, y));
  return exactFlush(value);
}

// u of a left face before the pressure makes the flow free of divergence.
FUNCTION float steppedU(int x, int y) {
  if (faceAt(x, y).x == 0.0f) return borderU(x) ? sideU(x, y) : flowAt(x, y).x;
  if (heldU(x, y)) {
    vec2 from = seenFromU(x, y);
    return exactFlush(wallU(x, y, from, valueIn(around(true, 0, from))));
  }
  precise float value = (movedPart(0, x, y) + frictionOn(true, 0, x, y)) - pushOnU(1.0f, x, y);
  return exactFlush(value);
}

FUNCTION float densityOf(vec4 dye) {
  precise float sum = (dye.x + dye.y) + dye.z;
  return sum;
}

FUNCTION float steppedV(int x, int y) {
  if (faceAt(x, y).y == 0.0f) return borderV(y) ? sideV(x, y) : flowAt(x, y).y;
  if (heldV(x, y)) {
    vec2 from = seenFromV(x, y);
    return exactFlush(wallV(x, y, from, valueIn(around(true, 1, from))));
  }
  precise float value = (movedPart(1, x, y) + frictionOn(true, 1, x, y)) - pushOnV(true, 1.0f, x, y);
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
  float u = faceAt(fx, iy).x == 0.0f || heldU(fx, iy) ? flowAt(fx, iy).x : carriedPart(0, fx, iy);
  float v = faceAt(ix, fy).y == 0.0f || heldV(ix, fy) ? flowAt(ix, fy).y : carriedPart(1, ix, fy);
  float heat = heats ? carriedPart(2, ix, iy) : 0.0f;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), heat, 0.0f);
}

// And of the pressure what is kept.
FUNCTION vec4 pushedCell(float kept, int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = pushedU(kept, faceX(x), iy);
  float v = pushedV(kept, ix, faceY(y));
  vec4 here = flowAt(x, y);
  precise float pressure = kept * here.w;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), here.z, exactFlush(pressure));
}

FUNCTION vec4 steppedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = steppedU(faceX(x), iy);
  float v = steppedV(ix, faceY(y));
  float heat = heats ? steppedHeat(ix, iy) : 0.0f;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), heat, flowAt(ix, iy).w);
}

FUNCTION float dyeWay(float speed) {
  precise float way = speed * stepData.dyeDt;
  return clamp(way, -maxDyeWay, maxDyeWay);
}

FUNCTION vec4 dyeThroughLeft(int x, int y) {
  return dyeFluxes(dyeWay(throughU(x, y)), dyeAt(x - 2, y), dyeAt(x - 1, y), dyeAt(x, y), dyeAt(x + 1, y));
}

FUNCTION vec4 dyeThroughTop(int x, int y) {
  return dyeFluxes(dyeWay(throughV(x, y)), dyeAt(x, y - 2), dyeAt(x, y - 1), dyeAt(x, y), dyeAt(x, y + 1));
}

FUNCTION vec4 dyedCell(int x, int y) {
  if (beyondOpen(x, y)) return vec4(0.0f);
  int ix = insideX(x), iy = insideY(y);
  precise vec4 next = dyeAt(ix, iy) - ((dyeThroughLeft(ix + 1, iy) - dyeThroughLeft(ix, iy)) +
                                       (dyeThroughTop(ix, iy + 1) - dyeThroughTop(ix, iy)));
  return next;
}

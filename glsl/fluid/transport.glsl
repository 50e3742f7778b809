// Update of a fluid's cells in a step, without the pressure solver. Compiles as GLSL (grid.glsl) and as C++, where it
// is inside a struct that provides the inputs: flowAt, carriedAt, dyeAt, faceAt, solidWord, sumAt, size, stepData,
// solidSet and the kinds of the sides.
//
// The grid is staggered: cell (x, y) stores u at the centre of its left face, v at the centre of its top face, and
// temperature and pressure at its centre. A ring of cells surrounds the grid, so x runs from -1 to size.x. Beyond a
// wall or an inflow, the velocity component along the side is mirrored, so that the mean of the values on both sides
// equals the side's velocity. u at size.x and v at size.y are faces of the border.

FUNCTION int insideX(int x) {
  if (leftKind == periodicSide) return x < 0 ? x + size.x : x >= size.x ? x - size.x : x;
  return clamp(x, 0, size.x - 1);
}

FUNCTION int insideY(int y) {
  if (topKind == periodicSide) return y < 0 ? y + size.y : y >= size.y ? y - size.y : y;
  return clamp(y, 0, size.y - 1);
}

// Clamps or wraps a face index along x. There is one face more than cells.
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

// Returns u in a row beyond the top or bottom side. The argument is u of the adjacent row inside the grid.
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

// Returns true if a cell of the ring is beyond an open side, where temperature, pressure and dye are 0.
FUNCTION bool beyondOpen(int x, int y) {
  return (x < 0 && leftKind == openSide) || (x >= size.x && rightKind == openSide) || (y < 0 && topKind == openSide) ||
         (y >= size.y && bottomKind == openSide);
}

// Return true for faces of the border. If such a face is open, the centre of the ring cell beyond it counts as half a
// cell away.
FUNCTION bool borderU(int x) {
  return leftKind != periodicSide && (x == 0 || x == size.x);
}

FUNCTION bool borderV(int y) {
  return topKind != periodicSide && (y == 0 || y == size.y);
}

// Return the prescribed normal speed of the sides: u for left and right, v for top and bottom.
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

// Four values around a point, and the fractional position of the point between them.
struct Around {
  float a, b, c, d;
  float x, y;
};

FUNCTION float valueIn(Around s) {
  return between(between(s.a, s.b, s.x), between(s.c, s.d, s.x), s.y);
}

// Returns component `which` of a cell: 0 is u, 1 is v, 2 is the temperature.
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

// Returns the velocity at the point of the cell at which component `which` is stored.
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

// Returns the curl dv/dx - du/dy at the upper left corner of a cell.
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

// Returns the fraction of the confinement force that is applied: 1 up to half of the expected speed, decreasing to 0 at
// the expected speed. The force must be limited, because it grows with the flow that it drives.
FUNCTION float confinementFactor(int x, int y) {
  vec4 here = flowAt(x, y);
  float speed = max(abs(here.x), abs(here.y));
  precise float share = 2.0f - speed * stepData.confined.x;
  return clamp(share, 0.0f, 1.0f);
}

// Vorticity confinement, dt epsilon N x omega, where omega is the vorticity, N the normalized gradient of |omega|, and
// epsilon the strength. confinementX() returns the x component at the centre of a left face, confinementY() the y
// component at the centre of a top face.
FUNCTION float confinementX(int x, int y) {
  float share = confinementFactor(x, y);
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
  float share = confinementFactor(x, y);
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

// Returns a correction of the second difference next to a wall. The mirrored value `beyond` belongs to a point one cell
// away, but the wall is only half a cell away. The correct difference is 8/3 wall - 4 here + 4/3 after, instead of 2
// wall - 3 here + after, where `wall` is the value on the wall.
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

// Returns half of the change by viscosity in a step.
FUNCTION float frictionOn(bool ofCarried, int which, int x, int y) {
  if (!viscous) return 0.0f;
  precise float pull = 0.5f * stepData.viscosity * pullOn(ofCarried, which, x, y);
  return pull;
}

// Returns the fraction of the last step's pressure that is used to predict the pressure of this step. It is 1 if the
// maximum speed (`fastest`, cells/s) is up to two cells per step, and 0 from three cells per step on. At that speed,
// vortices have moved on, so the old pressure gradient is in the wrong place and would add energy to the flow. With 0,
// the method is Chorin's projection, which is of first order and stable at any speed.
FUNCTION float keptPressure(float fastest) {
  precise float kept = 3.0f - fastest * stepData.dt;
  return clamp(kept, 0.0f, 1.0f);
}

// Half of the forces act before the advection and half after it. This is the trapezoidal rule along the fluid's paths,
// which is of second order in time. The confinement force has no order of accuracy and acts entirely before.
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

// Returns u at a left face after advection and forces, before the projection.
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

// The next functions return the values that a kernel writes for a cell of the grid or of the ring. carriedCell()
// returns them after the first advection.
FUNCTION vec4 carriedCell(int x, int y) {
  int fx = faceX(x), fy = faceY(y), ix = insideX(x), iy = insideY(y);
  float u = faceAt(fx, iy).x == 0.0f || heldU(fx, iy) ? flowAt(fx, iy).x : carriedPart(0, fx, iy);
  float v = faceAt(ix, fy).y == 0.0f || heldV(ix, fy) ? flowAt(ix, fy).y : carriedPart(1, ix, fy);
  float heat = heats ? carriedPart(2, ix, iy) : 0.0f;
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), heat, 0.0f);
}

// Returns a cell after the first half of the forces: its velocities, its temperature, and the pressure multiplied by
// the remaining fraction `kept`.
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

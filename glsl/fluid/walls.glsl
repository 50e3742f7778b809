// Obstacles in a fluid: distances of faces from obstacles, and the flow through partly closed faces. Compiles as GLSL
// and as C++ as part of transport.glsl.

// Returns the distance of a cell's centre from the nearest obstacle (from solidWord, see model.glsl).
FUNCTION float offWall(int x, int y) {
  return wallDistance(solidWord(insideX(x), insideY(y)));
}

FUNCTION float offWallU(int x, int y) {
  precise float mean = 0.5f * (offWall(x - 1, y) + offWall(x, y));
  return mean;
}

FUNCTION float offWallV(int x, int y) {
  precise float mean = 0.5f * (offWall(x, y - 1) + offWall(x, y));
  return mean;
}

// Returns true for a partly open face whose centre is inside a no-slip wall. Before the projection, the velocity of
// such a face follows from the wall and the adjacent fluid, not from the momentum equation.
FUNCTION bool heldU(int x, int y) {
  if (!obstacles || obstaclesSlip || borderU(x)) return false;
  float open = faceAt(x, y).x;
  return open > 0.0f && open < 1.0f && offWallU(x, y) <= 0.0f;
}

FUNCTION bool heldV(int x, int y) {
  if (!obstacles || obstaclesSlip || borderV(y)) return false;
  float open = faceAt(x, y).y;
  return open > 0.0f && open < 1.0f && offWallV(x, y) <= 0.0f;
}

// Returns a component of an obstacle's velocity at p: along x if `which` is 0, along y if it is 1.
FUNCTION float solidSpeed(int which, uint word, vec2 p) {
  FluidSolid solid = solidSet.solids[int((word >> 16u) & 255u)];
  precise float u = solid.velocity.x - solid.place.z * (p.y - solid.place.y);
  precise float v = solid.velocity.y + solid.place.z * (p.x - solid.place.x);
  return which == 0 ? u : v;
}

FUNCTION uint nearerWall(uint a, uint b) {
  return (b & 0xffffu) < (a & 0xffffu) ? b : a;
}

// Returns the velocity of the obstacle nearest to a face, evaluated at p.
FUNCTION float solidUAt(int x, int y, vec2 p) {
  if (!obstaclesMove) return 0.0f;
  return solidSpeed(0, nearerWall(solidWord(insideX(x - 1), insideY(y)), solidWord(insideX(x), insideY(y))), p);
}

FUNCTION float solidVAt(int x, int y, vec2 p) {
  if (!obstaclesMove) return 0.0f;
  return solidSpeed(1, nearerWall(solidWord(insideX(x), insideY(y - 1)), solidWord(insideX(x), insideY(y))), p);
}

FUNCTION float solidU(int x, int y) {
  return solidUAt(x, y, placeOf(0, x, y));
}

FUNCTION float solidV(int x, int y) {
  return solidVAt(x, y, placeOf(1, x, y));
}

// Returns the point at the distance wallReach from the wall that is reached from p along the gradient of the distance.
// `off` is the distance of p from the wall.
FUNCTION vec2 seenFrom(vec2 p, float off, float slopeX, float slopeY) {
  precise float length2 = slopeX * slopeX + slopeY * slopeY;
  precise float way = (wallReach - off) * exactInverseSqrt(max(length2, 0.01f));
  precise float x = p.x + way * slopeX;
  precise float y = p.y + way * slopeY;
  return heldPoint(vec2(x, y));
}

FUNCTION vec2 seenFromU(int x, int y) {
  precise float across = offWall(x, y) - offWall(x - 1, y);
  precise float along = 0.25f * ((offWall(x - 1, y + 1) + offWall(x, y + 1)) - (offWall(x - 1, y - 1) + offWall(x, y - 1)));
  return seenFrom(placeOf(0, x, y), offWallU(x, y), across, along);
}

FUNCTION vec2 seenFromV(int x, int y) {
  precise float across = 0.25f * ((offWall(x + 1, y - 1) + offWall(x + 1, y)) - (offWall(x - 1, y - 1) + offWall(x - 1, y)));
  precise float along = offWall(x, y) - offWall(x, y - 1);
  return seenFrom(placeOf(1, x, y), offWallV(x, y), across, along);
}

FUNCTION vec2 seenFromCell(int x, int y) {
  precise float across = 0.5f * (offWall(x + 1, y) - offWall(x - 1, y));
  precise float along = 0.5f * (offWall(x, y + 1) - offWall(x, y - 1));
  return seenFrom(placeOf(2, x, y), offWall(x, y), across, along);
}

// Extrapolates the fluid's velocity into a wall. With no slip, the difference from the obstacle's velocity is linear in
// the distance and 0 on the wall. With slip, the fluid's velocity continues unchanged. `seen` and `solidThere` are the
// fluid's and the obstacle's velocity at the sampled point; `solid` is the obstacle's velocity at the point in the
// wall.
FUNCTION float beyondWall(float seen, float solidThere, float solid, float off) {
  float held = max(off, -wallReach);
  precise float value = solid + (seen - solidThere) * (held * perWallReach);
  return obstaclesSlip ? seen : value;
}

FUNCTION float wallU(int x, int y, vec2 from, float seen) {
  return beyondWall(seen, solidUAt(x, y, from), solidU(x, y), offWallU(x, y));
}

FUNCTION float wallV(int x, int y, vec2 from, float seen) {
  return beyondWall(seen, solidVAt(x, y, from), solidV(x, y), offWallV(x, y));
}

// Returns the flow through a face: the fluid flows through the open part, and a moving obstacle through the remaining
// part. A closed face at a side has the side's prescribed speed.
FUNCTION float through(float weight, bool border, float speed, float solid) {
  precise float open = border ? 0.5f * weight : weight;
  precise float flow = open * speed + (border ? 0.0f : 1.0f - open) * solid;
  return border && weight == 0.0f ? speed : flow;
}

FUNCTION float throughU(int x, int y) {
  float weight = faceAt(x, y).x;
  return through(weight, borderU(x), flowAt(x, y).x, weight < 1.0f ? solidU(x, y) : 0.0f);
}

FUNCTION float throughV(int x, int y) {
  float weight = faceAt(x, y).y;
  return through(weight, borderV(y), flowAt(x, y).y, weight < 1.0f ? solidV(x, y) : 0.0f);
}

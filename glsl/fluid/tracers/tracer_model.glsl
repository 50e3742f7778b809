// Tracers: massless particles that move with a fluid and draw streaks. Compiles as GLSL and as C++, after
// common/exact.glsl, common/hash.glsl and fluid/wind_model.glsl. The including file provides tracerData (TracerStep)
// and tracerInSolid(x, y), which returns true for a cell inside an obstacle. A tracer is a vec4: xy is the position in
// cells, z the age in seconds, w the number of restarts.

struct TracerMove {
  vec4 next;
  vec2 from;   // Start of the drawn segment
  vec2 to;     // End of the drawn segment, before it is wrapped on a torus
  bool draws;
};

FUNCTION float tracerUnit(uint bits) {
  precise float u = float(int(bits >> 8u)) * 5.9604645e-8f;
  return u;
}

FUNCTION float tracerLife(int i) {
  uvec3 h = hash3(uvec3(uint(i), 0x51edu, uint(tracerData.seed)));
  precise float life = tracerData.seconds * (1.0f + 0.4f * signedUnit(h.x));
  return life;
}

// Returns a tracer at a random position outside obstacles. After four unsuccessful tries, the tracer may be inside an
// obstacle.
FUNCTION vec4 tracerBorn(int i, int generation, float age) {
  vec4 born = vec4(0.0f, 0.0f, age, float(generation));
  bool placed = false;
  for (int d = 0; d < 4; ++d) {
    uvec3 h = hash3(uvec3(uint(i), uint(4 * generation + d), uint(tracerData.seed) ^ 0x7f4a7c15u));
    precise float x = tracerUnit(h.x) * float(windGrid.size.x);
    precise float y = tracerUnit(h.y) * float(windGrid.size.y);
    if (!placed) born = vec4(x, y, born.z, born.w);
    placed = placed || !tracerInSolid(int(x), int(y));
  }
  return born;
}

// Returns tracer i for the first frame. Ages are random, so that the tracers do not all restart at the same time.
FUNCTION vec4 tracerFirst(int i) {
  uvec3 h = hash3(uvec3(uint(i), 0xa9e5u, uint(tracerData.seed)));
  precise float age = tracerUnit(h.y) * tracerLife(i);
  return tracerBorn(i, 0, age);
}

FUNCTION float tracerHeld(float p, int cells, bool wraps) {
  float end = float(cells);
  precise float after = p + end;
  precise float before = p - end;
  float turned = p < 0.0f ? after : p >= end ? before : p;
  return clamp(wraps ? turned : p, 0.0f, end);
}

FUNCTION vec2 tracerHeldIn(vec2 p) {
  return vec2(tracerHeld(p.x, windGrid.size.x, tracerData.wrapsX == 1), tracerHeld(p.y, windGrid.size.y, tracerData.wrapsY == 1));
}

// Moves a tracer by the midpoint rule, x' = x + dt u(x + dt/2 u(x)), where u is the flow.
FUNCTION TracerMove tracerMoved(int i, vec4 tracer) {
  vec2 p = vec2(tracer.x, tracer.y);
  vec2 first = vec2(windPart(0, p.x, p.y), windPart(1, p.x, p.y));
  precise vec2 half_ = p + first * (0.5f * tracerData.dt);
  vec2 middle = tracerHeldIn(half_);
  vec2 velocity = vec2(windPart(0, middle.x, middle.y), windPart(1, middle.x, middle.y));
  precise vec2 end = p + velocity * tracerData.dt;
  precise float age = tracer.z + tracerData.dt;
  vec2 held = tracerHeldIn(end);
  bool outX = tracerData.wrapsX == 0 && (end.x < 0.0f || end.x > float(windGrid.size.x));
  bool outY = tracerData.wrapsY == 0 && (end.y < 0.0f || end.y > float(windGrid.size.y));
  int x = min(int(held.x), windGrid.size.x - 1), y = min(int(held.y), windGrid.size.y - 1);
  bool ends = outX || outY || age >= tracerLife(i) || tracerInSolid(x, y);
  TracerMove m;
  m.next = vec4(held.x, held.y, age, tracer.w);
  if (ends) m.next = tracerBorn(i, int(tracer.w) + 1, 0.0f);
  m.from = p;
  m.to = end;
  m.draws = !ends;
  return m;
}

// Returns the number of points of a streak: two per cell of length, at most 32. A streak adds 4096 units per cell of
// its length. Each point distributes its part of them bilinearly among the four cells around it.
FUNCTION int tracerPoints(float length_) {
  precise float wanted = length_ * 2.0f + 1.0f;
  return clamp(int(wanted), 1, 32);
}

FUNCTION float tracerLength(vec2 from, vec2 to) {
  precise float dx = to.x - from.x;
  precise float dy = to.y - from.y;
  precise float squared = dx * dx + dy * dy;
  return exactSqrt(squared);
}

// Returns the cell (xy) to which point k contributes at one of the four corners around it, and the contributed units
// (z).
FUNCTION ivec3 tracerMark(vec2 from, vec2 to, float length_, int points, int k, int corner) {
  float per = exactReciprocal(float(points));
  precise float along = (float(k) + 0.5f) * per;
  precise float x = from.x + (to.x - from.x) * along - 0.5f;
  precise float y = from.y + (to.y - from.y) * along - 0.5f;
  int ix = int(floor(x)), iy = int(floor(y));
  precise float fx = x - float(ix);
  precise float fy = y - float(iy);
  precise float restX = 1.0f - fx;
  precise float restY = 1.0f - fy;
  float partX = (corner & 1) == 1 ? fx : restX;
  float partY = (corner & 2) == 2 ? fy : restY;
  precise float units = length_ * per * 4096.0f;
  precise float share = units * partX * partY;
  int cx = ix + (corner & 1), cy = iy + (corner >> 1);
  if (tracerData.wrapsX == 1) cx = cx < 0 ? cx + windGrid.size.x : cx >= windGrid.size.x ? cx - windGrid.size.x : cx;
  if (tracerData.wrapsY == 1) cy = cy < 0 ? cy + windGrid.size.y : cy >= windGrid.size.y ? cy - windGrid.size.y : cy;
  return ivec3(cx, cy, int(share));
}

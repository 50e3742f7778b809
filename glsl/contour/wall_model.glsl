// Contact with a solid in the shape that raise.comp draws: ground at the height of each class, and vertical walls along
// the contours. Level k defines a prism: the region where the field is at or above the level, from the bottom to the
// height of class k. Level 0 is the whole block, bounded by the outermost samples. Compiles as GLSL and as C++. The
// including file provides `wallGrid` (WallGrid), loadWallClass(int, int) for a sample and loadWallValue(int, int) for a
// cell of the field, and first includes wall_types.glsl, contour/model.glsl and common/exact.glsl. If BRANCHES is
// defined, squares without a wall are skipped, which saves time on GPUs but not on software drivers.

struct WallMotion {
  vec3 position;
  vec3 velocity;
};

// Corner of a square. Samples outside the block have class -1. `inField` is false outside the field, which includes the
// ring of samples.
struct WallSample {
  int class_;
  float value;
  bool inField;
};
struct WallSquare {
  WallSample a, b, c, d;  // Corners in the same order as in Corners
};

// Returns a position in squares, relative to sample (0, 0).
FUNCTION vec2 wallPlace(vec3 p) {
  precise vec2 place = (vec2(p.x, p.z) - wallGrid.corner) * wallGrid.perSpacing;
  // A position that is far away or NaN cannot be converted to int.
  bool near = abs(place.x) < 1e6f && abs(place.y) < 1e6f;
  return near ? place : vec2(-1e6f);
}

FUNCTION int wallClass(int x, int y) {
  bool there = x >= 0 && y >= 0 && x < wallGrid.samples.x && y < wallGrid.samples.y;
  int class_ = loadWallClass(there ? x : 0, there ? y : 0);
  return there ? class_ : -1;
}

FUNCTION WallSample wallSample(int x, int y) {
  WallSample s;
  s.class_ = wallClass(x, y);
  s.inField = x >= 1 && y >= 1 && x <= wallGrid.samples.x - 2 && y <= wallGrid.samples.y - 2;
  s.value = loadWallValue(x - 1, y - 1);
  return s;
}

// Returns the position of the contour on an edge as a fraction, 0 to 1. The contour around the block passes through the
// outermost samples.
FUNCTION float wallCrossing(WallSample first, WallSample second, float level) {
  bool linear = first.inField && second.inField;
  float part = linear ? crossingPlace(first.value, second.value, level) : 0.5f;
  part = second.class_ < 0 ? 0.0f : part;
  return first.class_ < 0 ? 1.0f : part;
}

// Piece of a contour within a square, in the square's coordinates. The low side is to the left of the direction from
// `to` to `from`. `wide` is true if the square has two or three low corners.
struct WallChord {
  vec2 from, to;
  bool there, wide;
};

FUNCTION vec2 ofFour(vec2 a, vec2 b, vec2 c, vec2 d, int i) {
  int place = i & 3;
  return place == 0 ? a : place == 1 ? b : place == 2 ? c : d;
}

// Returns the contour's first piece in a square, or the second piece, which only a saddle has. A piece enters on the
// side where the walk falls below the level, and leaves where the walk next rises above it.
FUNCTION WallChord wallChord(WallSquare s, int region, float level, bool second) {
  bool a = s.a.class_ >= region;
  bool b = s.b.class_ >= region;
  bool c = s.c.class_ >= region;
  bool d = s.d.class_ >= region;
  bool saddle = a == c && b == d && a != b;
  int begin = a && !b ? 0 : b && !c ? 1 : c && !d ? 2 : 3;
  begin = second ? begin + 2 : begin;
  int i = begin & 3;
  bool next = i == 0 ? c : i == 1 ? d : i == 2 ? a : b;
  bool afterNext = i == 0 ? d : i == 1 ? a : i == 2 ? b : c;
  int end = next ? i + 1 : afterNext ? i + 2 : i + 3;
  vec2 top = vec2(wallCrossing(s.a, s.b, level), 0.0f);
  vec2 right = vec2(1.0f, wallCrossing(s.b, s.c, level));
  vec2 bottom = vec2(wallCrossing(s.d, s.c, level), 1.0f);
  vec2 left = vec2(0.0f, wallCrossing(s.a, s.d, level));
  WallChord chord;
  chord.from = ofFour(top, right, bottom, left, i);
  chord.to = ofFour(top, right, bottom, left, end);
  chord.there = second ? saddle : !(a == b && b == c && c == d);
  chord.wide = !next;
  return chord;
}

// Returns true if the point is on the low side of the piece. A piece of length zero cuts off a corner of size zero; the
// result is then true only if the other corners are low.
FUNCTION bool isBelow(WallChord chord, vec2 at) {
  precise vec2 along = chord.from - chord.to;
  precise vec2 away = at - chord.to;
  precise float side = along.x * away.y - along.y * away.x;
  return chord.there && (chord.wide ? side >= 0.0f : side > 0.0f);
}

FUNCTION WallSquare wallSquare(int x, int y) {
  WallSquare s;
  s.a = wallSample(x, y);
  s.b = wallSample(x + 1, y);
  s.c = wallSample(x + 1, y + 1);
  s.d = wallSample(x, y + 1);
  return s;
}

FUNCTION float wallLevel(int region) {
  return wallGrid.levels[max(region, 1) - 1];  // Region 0 has no level, and the caller does not use the value.
}

#ifdef BRANCHES
FUNCTION bool isEven(WallSquare s, int region) {
  bool a = s.a.class_ >= region;
  return a == (s.b.class_ >= region) && a == (s.c.class_ >= region) && a == (s.d.class_ >= region);
}

FUNCTION bool isSaddle(WallSquare s, int region) {
  bool a = s.a.class_ >= region;
  bool b = s.b.class_ >= region;
  return a == (s.c.class_ >= region) && b == (s.d.class_ >= region) && a != b;
}
#endif

FUNCTION bool isWithin(WallSquare s, vec2 at, int region) {
#ifdef BRANCHES
  if (isEven(s, region)) return s.a.class_ >= region;
#endif
  float level = wallLevel(region);
  bool low = isBelow(wallChord(s, region, level, false), at) || isBelow(wallChord(s, region, level, true), at);
  bool even = (s.a.class_ >= region) == (s.b.class_ >= region) && (s.b.class_ >= region) == (s.c.class_ >= region) &&
              (s.c.class_ >= region) == (s.d.class_ >= region);
  return even ? s.a.class_ >= region : !low;
}

// Returns the lowest class whose ground is above y.
FUNCTION int levelOver(float y) {
  int level = 0;
  for (int k = 0; k <= wallGrid.levelCount; ++k) level += wallGrid.heights[k] <= y ? 1 : 0;
  return level;
}

// Returns true if the point is inside the solid. The prisms are nested, so it is enough to test the lowest prism that
// is high enough.
FUNCTION bool isRock(vec3 p) {
  vec2 place = wallPlace(p);
  precise vec2 base = floor(place);
  precise vec2 at = place - base;
  int region = levelOver(p.y);
  bool roofed = wallGrid.ceiling == 1 && region == 2 && p.y < wallGrid.roof;
  region = roofed ? 0 : region;
  return p.y > wallGrid.bottom && isWithin(wallSquare(int(base.x), int(base.y)), at, region);
}

// Nearest point on the walls of a level, relative to a given point.
struct WallNear {
  vec2 offset;    // Vector from the nearest wall point to the given point, in squares
  vec2 outward;   // Outward direction of the wall, of any length
  float squared;  // |offset|^2, or 1e9 if there is no wall nearby
  bool beside;    // True if the nearest wall point is not an end of a piece
  bool within;    // True if the given point is inside the level's region
};

FUNCTION WallNear nearerOf(WallNear n, WallChord chord, vec2 at) {
  precise vec2 along = chord.from - chord.to;
  precise vec2 away = at - chord.to;
  precise float squared = along.x * along.x + along.y * along.y;
  precise float t = (along.x * away.x + along.y * away.y) * exactReciprocal(max(squared, 1e-12f));
  bool beside = t > 0.0f && t < 1.0f;
  t = min(max(t, 0.0f), 1.0f);
  precise vec2 offset = away - along * t;
  precise float distance_ = offset.x * offset.x + offset.y * offset.y;
  bool nearer = chord.there && distance_ < n.squared;
  n.offset = nearer ? offset : n.offset;
  n.outward = nearer ? vec2(-along.y, along.x) : n.outward;
  n.squared = nearer ? distance_ : n.squared;
  n.beside = nearer ? beside : n.beside;
  return n;
}

// Returns the nearest wall point among rows x rows squares around the position. If `rows` is 0, returns that there is
// no wall.
FUNCTION WallNear nearestWall(vec2 place, int region, int rows) {
  precise vec2 base = floor(place);
  float level = wallLevel(region);
  int half_ = rows >> 1;
  WallNear n;
  n.offset = vec2(0.0f);
  n.outward = vec2(1.0f, 0.0f);
  n.squared = 1e9f;
  n.beside = false;
  n.within = false;
  for (int j = 0; j < rows; ++j) {
    int y = int(base.y) + j - half_;
    int x = int(base.x) - half_;
    WallSquare s;
    s.b = wallSample(x, y);
    s.c = wallSample(x, y + 1);
    for (int i = 0; i < rows; ++i) {
      s.a = s.b;
      s.d = s.c;
      s.b = wallSample(x + i + 1, y);
      s.c = wallSample(x + i + 1, y + 1);
      precise vec2 at = place - vec2(float(x + i), float(y));
#ifdef BRANCHES
      if (isEven(s, region)) {  // A square without a wall is the most frequent case; GPUs then skip the remaining work
        if (i == half_ && j == half_) n.within = s.a.class_ >= region;
        continue;
      }
      n = nearerOf(n, wallChord(s, region, level, false), at);
      if (isSaddle(s, region)) n = nearerOf(n, wallChord(s, region, level, true), at);
#else
      n = nearerOf(n, wallChord(s, region, level, false), at);
      n = nearerOf(n, wallChord(s, region, level, true), at);
#endif
      if (i == half_ && j == half_) n.within = isWithin(s, at, region);
    }
  }
  return n;
}

// Returns the lowest class (x) and the highest class (y) of the samples around the position. If `reads` is false, no
// sample is read.
FUNCTION ivec2 classesAround(vec2 place, bool reads) {
  precise vec2 base = floor(place);
  int x = int(base.x) - wallGrid.squares;
  int y = int(base.y) - wallGrid.squares;
  int across = reads ? 2 * wallGrid.squares + 2 : 0;
  ivec2 range = ivec2(maxWallLevels + 1, -1);
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i) {
      int class_ = wallClass(x + i, y + j);
      range = ivec2(min(range.x, class_), max(range.y, class_));
    }
  return range;
}

// Returns the velocity after contact. The inward velocity is reversed and multiplied by the bounce fraction; the
// tangential velocity is multiplied by `kept`. A velocity that already points away does not change.
FUNCTION vec3 thrownBack(vec3 velocity, vec3 normal) {
  float inward = exactDot(velocity, normal);
  precise float back = -inward * wallGrid.bounce;
  precise vec3 thrown = (velocity - normal * inward) * wallGrid.kept + normal * back;
  return inward < 0.0f ? thrown : velocity;
}

// Result of pushing a point out of a prism. position: the corrected position; normal: the direction of the push;
// touches: true if the point had to move; byWall: true if it was pushed sideways or by a wall's upper edge, false if
// straight up or down.
struct WallPush {
  vec3 position;
  vec3 normal;
  bool touches, byWall;
};

// Returns the horizontal normal of a wall. Beside a wall, it is the outward direction of the wall, which is accurate at
// any distance. Near a corner, it is the direction to the point, unless the distance is too short.
FUNCTION vec3 wallNormal(WallNear wall) {
  bool straight = wall.beside || wall.squared < 1e-4f;
  precise vec2 direction = straight ? wall.outward : wall.within ? -wall.offset : wall.offset;
  precise float squared = direction.x * direction.x + direction.y * direction.y;
  precise vec2 unit = direction * exactInverseSqrt(max(squared, 1e-30f));
  return vec3(unit.x, 0.0f, unit.y);
}

// Pushes a point out of a wall. A point inside the prism is moved to the outside; a point outside is moved to the
// minimum distance. For points above the wall, the upper edge of the wall is treated as rounded.
FUNCTION WallPush byWall(vec3 p, WallNear wall, float low, float high) {
  precise float over = p.y > high ? p.y - high : p.y < low ? p.y - low : 0.0f;
  precise float across = exactSqrt(wall.squared) * wallGrid.spacing;
  precise float squared = across * across + over * over;
  float inverse = exactInverseSqrt(max(squared, 1e-30f));
  bool round_ = over != 0.0f && !wall.within;
  vec3 level = wallNormal(wall);
  precise vec3 slanted = vec3(level.x * across, over, level.z * across) * inverse;
  vec3 normal = round_ ? slanted : level;
  float away = round_ ? exactSqrt(squared) : across;
  precise float depth = wallGrid.reach + (wall.within ? across : -away);
  precise vec3 position = p + normal * depth;
  WallPush push;
  push.position = position;
  push.normal = normal;
  push.touches = wall.squared < 1e8f && depth > 0.0f;
  push.byWall = true;
  return push;
}

// Pushes a point out of a prism, back to the side that it came from: up if it was above, down if it was below,
// otherwise through the nearest wall. A point that the solid has just enclosed (`caught`) takes the shortest path.
FUNCTION WallPush outOfPrism(vec3 p, WallNear wall, float low, float high, vec3 before, bool caught) {
  precise float rise = high - p.y;
  precise float riseInSquares = rise * wallGrid.perSpacing;
  precise float riseSquared = riseInSquares * riseInSquares;
  bool sideways = caught ? wall.squared < riseSquared : before.y < high && before.y > low;
  bool inside = p.y < high && p.y > low;
  bool walled = wall.squared < 1e8f;
  WallPush push = byWall(p, wall, low, high);
  bool vertical = wall.within && !(inside && sideways && walled);
  bool under = inside ? before.y <= low && !caught : p.y <= low;
  precise float over = high + wallGrid.reach;
  precise float below = low - wallGrid.reach;
  bool touches = under ? p.y > below : p.y < over;
  push.position = vertical ? vec3(p.x, under ? below : over, p.z) : push.position;
  push.normal = vertical ? vec3(0.0f, under ? -1.0f : 1.0f, 0.0f) : push.normal;
  push.touches = vertical ? touches : push.touches;
  push.byWall = !vertical;
  return push;
}

// Position at which a path first enters rock, tested in steps of half a square, at most sixteen; if it enters none, the
// path's end.
struct WallWay {
  vec3 before, at;
};
FUNCTION WallWay wayUntilRock(vec3 from, vec3 to, bool near, bool caught) {
  precise vec3 way = to - from;
  precise vec3 halves = way * (wallGrid.perSpacing * 2.0f);
  float length_ = exactSqrt(exactDot(halves, halves));
  int count = int(min(length_, 15.0f)) + 1;
  count = caught || !near ? 1 : count;
  float share = exactReciprocal(float(count));
  WallWay w;
  w.at = from;
  w.before = from;
  bool rock = false;
  for (int i = 1; i <= count && !rock; ++i) {
    precise vec3 next = from + way * (float(i) * share);
    w.before = w.at;
    w.at = i == count ? to : next;
    if (i < count) rock = isRock(w.at);
  }
  return w;
}

// Returns true if the bounding box of a path comes within the distance `reach` of the solid.
FUNCTION bool isNearSolid(vec3 from, vec3 to) {
  float last = wallGrid.ceiling == 1 ? wallGrid.roof : wallGrid.heights[wallGrid.levelCount];
  precise float high = last + wallGrid.reach;
  precise float low = wallGrid.bottom - wallGrid.reach;
  precise vec2 first = wallGrid.corner - vec2(wallGrid.reach);
  precise vec2 end = wallGrid.corner + vec2(wallGrid.samples - 1) * wallGrid.spacing + vec2(wallGrid.reach);
  return min(from.y, to.y) < high && max(from.y, to.y) > low && min(from.x, to.x) < end.x &&
         max(from.x, to.x) > first.x && min(from.z, to.z) < end.y && max(from.z, to.z) > first.y;
}

// Result of a round that pushes a point out of all prisms around it, starting with the lowest. With a ceiling, the
// third prism is the rock above it.
struct WallRound {
  WallMotion motion;
  bool again;  // True if the point touched a wall, so that another wall may have to be tested
};
FUNCTION WallRound outOfPrisms(WallMotion m, vec3 before, bool caught) {
  ivec2 classes = classesAround(wallPlace(m.position), true);
  precise float lowest = m.position.y - wallGrid.reach;
  bool ceiling = wallGrid.ceiling == 1;
  int last = ceiling ? (classes.y >= 0 ? 2 : -1) : classes.y;
  int first = ceiling ? 0 : max(levelOver(lowest), max(classes.x, 0));
  bool again = false;
  for (int k = first; k <= last; ++k) {
    bool above = k > wallGrid.levelCount;
    int region = above ? 0 : k;
    float low = above ? wallGrid.heights[1] : wallGrid.bottom;
    float high = ceiling && k > 0 ? wallGrid.roof : wallGrid.heights[min(k, wallGrid.levelCount)];
    bool walled = classes.x < region && classes.y >= region;
    WallNear wall = nearestWall(wallPlace(m.position), region, walled ? 2 * wallGrid.squares + 1 : 0);
    wall.within = walled ? wall.within : classes.x >= region;
    WallPush push = outOfPrism(m.position, wall, low, high, before, caught);
    m.velocity = push.touches ? thrownBack(m.velocity, push.normal) : m.velocity;
    m.position = push.touches ? push.position : m.position;
    again = again || (push.touches && push.byWall);
  }
  WallRound round_;
  round_.motion = m;
  round_.again = again;
  return round_;
}

// Moves a point from `from` to `to` in the presence of the solid: stops it where the path enters the solid, and keeps
// the minimum distance. If the point is still in rock afterwards, it returns to its previous position. A point that the
// solid has enclosed is moved to the top.
FUNCTION WallMotion outOfWalls(vec3 from, vec3 to, vec3 velocity) {
  bool near = isNearSolid(from, to);
  bool caught = near && isRock(from);
  WallWay way = wayUntilRock(from, to, near, caught);
  WallMotion m;
  m.position = way.at;
  m.velocity = velocity;
  bool again = near;
  for (int round_ = 0; round_ < 3 && again; ++round_) {
    WallRound next = outOfPrisms(m, way.before, caught);
    m = next.motion;
    again = next.again;
  }
  bool held = near && isRock(m.position);
  int highest = max(classesAround(wallPlace(m.position), held && caught).y, 0);
  precise float top = (wallGrid.ceiling == 1 ? wallGrid.roof : wallGrid.heights[highest]) + wallGrid.reach;
  vec3 lifted = vec3(m.position.x, top, m.position.z);
  m.position = !held ? m.position : caught ? lifted : way.before;
  return m;
}

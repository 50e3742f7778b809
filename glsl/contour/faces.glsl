// Walls and faces of a square that contours cross (model.glsl).

void putTriangle(uint place, uint a, uint b, uint c) {
  if (place + 3u > indexRoom) return;
  indices[place] = a;
  indices[place + 1u] = b;
  indices[place + 2u] = c;
}

// Writes the wall from a point to the next point of its contour. The wall faces the lower ground.
void putWall(uint place, uint point, uint next) {
  if (point < pointRoom) nextPoints[point] = next;
  uint right = firstPoint + 4u * point, left = firstPoint + 4u * next;
  putTriangle(place + 6u * point, left + wallBottom, right + wallBottom, right + wallTop);
  putTriangle(place + 6u * point + 3u, left + wallBottom, right + wallTop, left + wallTop);
}

// Returns the point at which a contour leaves the square. The contour enters through `side`, where the walk around the
// square falls below the level. It leaves through the side at which the walk next rises above the level.
uint nextPoint(Corners q, Ranks ranks, int level, int side) {
  uint found = 0u;
  for (int step_ = 3; step_ >= 1; --step_) {
    int i = (side + step_) & 3;
    int here = cornerClass(q, i), next = cornerClass(q, (i + 1) & 3);
    if (here < level && next >= level) found = edgeRank(ranks, i) + uint(level - 1 - here);
  }
  return found;
}

// A face as a triangle fan, with its corners in walking order. The triangles are oriented to be visible from above.
// They are first recorded and then stored together, because a software driver would execute each store instruction for
// every square. A triangle takes twelve bits, four per corner: 0 to 3 is a corner of the square, 4 to 7 a point of the
// higher level on an edge, 8 to 11 a point of the lower level.
struct Fan {
  uint first, previous;
  int corners;
  uvec3 noted;
  int triangles;
};
void addCorner(inout Fan fan, uint corner_) {
  if (fan.corners == 0) fan.first = corner_;
  if (fan.corners >= 2) {
    uint triangle = (fan.first | corner_ << 4u | fan.previous << 8u) << uint(12 * (fan.triangles & 1));
    if (fan.triangles < 2) fan.noted.x |= triangle;
    else if (fan.triangles < 4) fan.noted.y |= triangle;
    else fan.noted.z |= triangle;
    ++fan.triangles;
  }
  fan.previous = corner_;
  ++fan.corners;
}

// Returns the vertex of a recorded corner. For a point, the index is the edge's first point plus the number of
// levels on the edge below the point's level.
uint vertexOf(uint corner_, int class_, Corners q, Ranks ranks, uvec4 vertices) {
  int i = int(corner_ & 3u);
  uint vertex = i == 0 ? vertices.x : i == 1 ? vertices.y : i == 2 ? vertices.z : vertices.w;
  int low = min(cornerClass(q, i), cornerClass(q, (i + 1) & 3));
  int level = corner_ < 8u ? class_ + 1 : class_;
  uint point = firstPoint + 4u * (edgeRank(ranks, i) + uint(level - 1 - low)) + (corner_ < 8u ? rimBelow : rimAbove);
  return corner_ < 4u ? vertex : point;
}

// Writes the faces of one class. The corners of a face are the square's corners of this class and the points of the two
// levels that bound the class, in walking order. If the higher level is a saddle, there are two faces, each around a
// low corner, and the walk begins at a high corner.
void facesOf(int class_, Corners q, Ranks ranks, uvec4 vertices, inout uint place) {
  bool split = isSaddle(q, class_ + 1);
  if (split && q.a <= class_) {
    q = Corners(q.b, q.c, q.d, q.a);
    ranks = Ranks(ranks.right, ranks.bottom, ranks.left, ranks.top);
    vertices = vertices.yzwx;
  }
  Fan fan = Fan(0u, 0u, 0, uvec3(0), 0);
  for (int i = 0; i < 4; ++i) {
    int here = cornerClass(q, i), next = cornerClass(q, (i + 1) & 3);
    int low = min(here, next), high = max(here, next);
    if (here == class_) addCorner(fan, uint(i));
    // If the classes rise along the side, the walk meets the lower level first.
    int level = here < next ? class_ : class_ + 1;
    for (int side = 0; side < 2; ++side) {
      if (level > low && level <= high) {
        if (split && level == class_ + 1 && here > next) fan.corners = 0;
        addCorner(fan, uint(i) + (level == class_ ? 8u : 4u));
      }
      level = 2 * class_ + 1 - level;
    }
  }
  for (int t = 0; t < fan.triangles; ++t) {
    uint triangle = (t < 2 ? fan.noted.x : t < 4 ? fan.noted.y : fan.noted.z) >> uint(12 * (t & 1));
    uint a = vertexOf(triangle & 15u, class_, q, ranks, vertices);
    uint b = vertexOf(triangle >> 4u & 15u, class_, q, ranks, vertices);
    uint c = vertexOf(triangle >> 8u & 15u, class_, q, ranks, vertices);
    putTriangle(place, a, b, c);
    place += 3u;
#ifdef CEILING
    uint lift = uint(samples.x * samples.y), points_ = firstPoint;
    putTriangle(place, a + (a < points_ ? lift : rimAbove), c + (c < points_ ? lift : rimAbove),
                b + (b < points_ ? lift : rimAbove));
    place += 3u;
#endif
  }
}

void faces(Corners q, Ranks ranks, ivec2 at, uint place) {
  uint me = cornerIndex(at), row = uint(samples.x);
  uvec4 vertices = uvec4(me, me + 1u, me + row + 1u, me + row);
#if defined CEILING
  if (minimumOf(q) == 0) facesOf(0, q, ranks, vertices, place);
#elif LEVELS == 1
  facesOf(0, q, ranks, vertices, place);
  facesOf(1, q, ranks, vertices, place);
#else
  for (int class_ = minimumOf(q); class_ <= greatestOf(q); ++class_) facesOf(class_, q, ranks, vertices, place);
#endif
}

// Marching squares on classes, where a sample's class is the number of levels at or below its value. The walk around a
// square visits the corners a, b, c, d: the first sample, the next sample in its row, the sample below that one, and
// the sample below the first (clockwise, seen from above). At a saddle, the high corners are connected and the low
// corners are not, so low regions are connected over edges only, high regions also over corners. Compiles as GLSL and
// as C++.

struct Corners {
  int a, b, c, d;  // Classes at (x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)
};

FUNCTION int crossingsBetween(int a, int b) {
  return abs(a - b);
}
FUNCTION int minimumOf(Corners q) {
  return min(min(q.a, q.b), min(q.c, q.d));
}
FUNCTION int greatestOf(Corners q) {
  return max(max(q.a, q.b), max(q.c, q.d));
}
// Returns the number of levels for which the square is a saddle: two opposite corners are above the level, and the
// other two are below it.
FUNCTION int saddlesOf(Corners q) {
  return max(min(q.a, q.c) - max(q.b, q.d), 0) + max(min(q.b, q.d) - max(q.a, q.c), 0);
}
FUNCTION bool isSaddle(Corners q, int level) {
  return (min(q.a, q.c) >= level && max(q.b, q.d) < level) || (min(q.b, q.d) >= level && max(q.a, q.c) < level);
}
FUNCTION int edgeCrossingsOf(Corners q) {
  return crossingsBetween(q.a, q.b) + crossingsBetween(q.b, q.c) + crossingsBetween(q.c, q.d) + crossingsBetween(q.d, q.a);
}

// Returns the number of triangles of the faces into which contours divide a square. A face with n corners has n - 2
// triangles. A crossing is a corner of both adjacent faces. Each level adds a face, and each saddle adds another face.
FUNCTION int trianglesOf(Corners q) {
  int faces = greatestOf(q) - minimumOf(q) + 1 + saddlesOf(q);
  return 4 + 2 * edgeCrossingsOf(q) - 2 * faces;
}
// Returns the number of triangles of the faces of class 0, for a single level.
FUNCTION int lowTrianglesOf(Corners q) {
  int low = int(q.a == 0) + int(q.b == 0) + int(q.c == 0) + int(q.d == 0);
  return low == 0 ? 0 : low + edgeCrossingsOf(q) - 2 * (1 + saddlesOf(q));
}

// Returns the position of the level between two samples as a fraction, 0 to 1.
FUNCTION float crossingPlace(float from, float to, float level) {
  precise float rise = to - from;
  precise float place = (level - from) * exactReciprocal(rise);
  return abs(rise) < 1e-30f ? 0.5f : clamp(place, 0.0f, 1.0f);
}

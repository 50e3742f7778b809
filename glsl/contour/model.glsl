// Marching squares on samples that are classes: how many levels a value reaches. A square's corners are walked from the
// first sample to the next one in its row, the one below that, and the one below the first; seen from above that is
// clockwise. High corners of a saddle are joined, low ones are not: so what is low is connected over edges only, what is
// high over corners too. Compiles as GLSL and as C++.

struct Corners {
  int a, b, c, d;  // classes: at (x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)
};

FUNCTION int crossingsBetween(int a, int b) {
  return abs(a - b);
}
FUNCTION int leastOf(Corners q) {
  return min(min(q.a, q.b), min(q.c, q.d));
}
FUNCTION int greatestOf(Corners q) {
  return max(max(q.a, q.b), max(q.c, q.d));
}
// Levels of which opposite corners are above and the other two below.
FUNCTION int saddlesOf(Corners q) {
  return max(min(q.a, q.c) - max(q.b, q.d), 0) + max(min(q.b, q.d) - max(q.a, q.c), 0);
}
FUNCTION bool isSaddle(Corners q, int level) {
  return (min(q.a, q.c) >= level && max(q.b, q.d) < level) || (min(q.b, q.d) >= level && max(q.a, q.c) < level);
}
FUNCTION int edgeCrossingsOf(Corners q) {
  return crossingsBetween(q.a, q.b) + crossingsBetween(q.b, q.c) + crossingsBetween(q.c, q.d) + crossingsBetween(q.d, q.a);
}

// Triangles of the faces into which contours cut a square: a face of n corners has n - 2. A crossing is a corner of the
// faces on both its sides, each level adds a face, and a saddle another.
FUNCTION int trianglesOf(Corners q) {
  int faces = greatestOf(q) - leastOf(q) + 1 + saddlesOf(q);
  return 4 + 2 * edgeCrossingsOf(q) - 2 * faces;
}
// Of the faces of class 0 alone, where there is one level.
FUNCTION int lowTrianglesOf(Corners q) {
  int low = int(q.a == 0) + int(q.b == 0) + int(q.c == 0) + int(q.d == 0);
  return low == 0 ? 0 : low + edgeCrossingsOf(q) - 2 * (1 + saddlesOf(q));
}

// Where the level lies on the way from one sample to the next, 0 to 1.
FUNCTION float crossingPlace(float from, float to, float level) {
  precise float rise = to - from;
  precise float place = (level - from) * exactReciprocal(rise);
  return abs(rise) < 1e-30f ? 0.5f : clamp(place, 0.0f, 1.0f);
}

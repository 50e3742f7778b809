// Helper functions for a square that contours cross and for the points on its edges.
const uint nowhere = 0xffffffffu;

// Index of the first point on each edge of a square.
struct Ranks {
  uint top, right, bottom, left;
};

int cornerClass(Corners q, int i) {
  return i == 0 ? q.a : i == 1 ? q.b : i == 2 ? q.c : q.d;
}
uint edgeRank(Ranks ranks, int i) {
  return i == 0 ? ranks.top : i == 1 ? ranks.right : i == 2 ? ranks.bottom : ranks.left;
}
uint cornerIndex(ivec2 at) {
  return uint(at.y * samples.x + at.x);
}
int squareTriangles(Corners q) {
#ifdef CEILING
  return 2 * lowTrianglesOf(q);
#else
  return trianglesOf(q);
#endif
}

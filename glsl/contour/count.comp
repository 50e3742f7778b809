// Counts the contributions of sixteen samples and of the squares that begin at them. x: number of crossings of the
// edges to the right and down. y: number of uniform squares (four corners of the same class). z: number of triangles in
// the other squares. w: one bit per square, uniform squares in the lower half and squares crossed by contours in the
// upper half. One invocation per sixteen samples.
#include "common/words.glsl"
#include "contour/samples.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(classesBinding, ClassBlock, classes)
STATE_WORDS(talliesBinding, TallyBlock, tallies)

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= elementCount()) return;
  int y = i / rowElements, x = 16 * (i - y * rowElements);
  if (y == samples.y - 1) {
    STORE_WORDS(tallies, i, uvec4(0));
    return;
  }
  bool last = x + 16 >= samples.x;
  uvec4 here = LOAD_INPUT_WORDS(classes, i), below = LOAD_INPUT_WORDS(classes, i + rowElements);
  Corners q;
  q.b = int(here.x & 255u);
  q.c = int(below.x & 255u);
  int after = outside, afterBelow = outside;
  if (!last) {
    after = int(LOAD_INPUT_WORDS(classes, i + 1).x & 255u);
    afterBelow = int(LOAD_INPUT_WORDS(classes, i + rowElements + 1).x & 255u);
  }
  int crossings = 0, triangles = 0;
  uint sheets = 0u, crossed = 0u;
  for (int k = 0; k < 16; ++k) {
    q.a = q.b;
    q.d = q.c;
    q.b = k == 15 ? after : int(byteOf(here, k + 1));
    q.c = k == 15 ? afterBelow : int(byteOf(below, k + 1));
    if (x + k >= samples.x - 1) break;
    crossings += crossingsBetween(q.a, q.b) + crossingsBetween(q.a, q.d);
    bool even = q.a == q.b && q.b == q.c && q.c == q.d;
    if (!even) crossed |= 1u << uint(k);
#ifdef CEILING
    if (even && q.a == 0) sheets |= 1u << uint(k);
    if (!even) triangles += 2 * lowTrianglesOf(q);
#else
    if (even) sheets |= 1u << uint(k);
    if (!even) triangles += trianglesOf(q);
#endif
  }
  STORE_WORDS(tallies, i, uvec4(uint(crossings), uint(bitCount(sheets)), uint(triangles), sheets | crossed << 16u));
}

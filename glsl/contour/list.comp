// Lists the squares that contours cross, with one entry per contour point: the square in which the contour continues
// from the point. x: index of the square's first sample. y: index of that sample's first point. z: index of the first
// point of the sample below. w: for one of the square's points, start of the square's triangles; for the others,
// `nowhere`. An invocation processes sixteen samples and counts the points on their edges. A point is a crossing of a
// contour and an edge. The points of a sample are ordered by edge (to the right, then down) and by ascending level.
#include "common/words.glsl"
#include "contour/samples.glsl"
#include "contour/types.glsl"
#include "contour/squares.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(classesBinding, ClassBlock, classes)
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
STATE_WORDS(listedBinding, SquareBlock, squares)
layout(std430, binding = drawBinding) restrict readonly buffer DrawBlock { ContourDraw draw; };
uniform uint fixedIndices;
uniform uint sheetIndices;  // Number of indices per uniform square (four corners of one class)
uniform uint pointRoom;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= elementCount()) return;
  int y = i / rowElements, x = 16 * (i - y * rowElements);
  if (y == samples.y - 1) return;
  uvec4 here = LOAD_INPUT_WORDS(classes, i), below = LOAD_INPUT_WORDS(classes, i + rowElements);
  uvec4 last = uvec4(outside);  // Classes two rows below
  if (y + 2 < samples.y) last = LOAD_INPUT_WORDS(classes, i + 2 * rowElements);
  ivec2 after = ivec2(outside);
  int afterBelow = outside;
  if (x + 16 < samples.x) {
    uvec4 next = LOAD_INPUT_WORDS(classes, i + 1);
    after = ivec2(next.x & 255u, next.x >> 8u & 255u);
    afterBelow = int(LOAD_INPUT_WORDS(classes, i + rowElements + 1).x & 255u);
  }
  uvec4 tally = LOAD_INPUT_WORDS(tallies, i), tallyBelow = LOAD_INPUT_WORDS(tallies, i + rowElements);
  uint rank = tally.x, rankBelow = tallyBelow.x;
  uint facePlace = fixedIndices + sheetIndices * draw.sheets + 6u * draw.points + 3u * tally.z;
  // The first sample of a square without a contour has no points, so only the other squares are visited.
  uint crossed = tally.w >> 16u;
  for (uint left = crossed | tallyBelow.w >> 16u; left != 0u; left &= left - 1u) {
    int k = findLSB(left);
    Corners q;
    q.a = int(byteOf(here, k));
    q.b = k == 15 ? after.x : int(byteOf(here, k + 1));
    q.c = k == 15 ? afterBelow : int(byteOf(below, k + 1));
    q.d = int(byteOf(below, k));
    int right = crossingsBetween(q.a, q.b), down = crossingsBetween(q.a, q.d);
    if ((crossed >> uint(k) & 1u) != 0u) {
      int beyond = k == 15 ? after.y : k == 14 ? after.x : int(byteOf(here, k + 2));
      ivec2 at = ivec2(x + k, y);
      Ranks ranks;
      ranks.top = rank;
      ranks.left = rank + uint(right);
      ranks.right = rank + uint(right + down + crossingsBetween(q.b, beyond));
      ranks.bottom = rankBelow;
      uint place = facePlace;
      for (int side = 0; side < 4; ++side) {
        int first = cornerClass(q, side), second = cornerClass(q, (side + 1) & 3);
        for (int level = second + 1; level <= first; ++level) {
          uint point = edgeRank(ranks, side) + uint(level - 1 - second);
          if (point < pointRoom) STORE_WORDS(squares, point, uvec4(cornerIndex(at), rank, rankBelow, place));
          place = nowhere;
        }
      }
      facePlace += 3u * uint(squareTriangles(q));
    }
    rank += uint(right + down);
    rankBelow += uint(crossingsBetween(q.d, q.c) + crossingsBetween(q.d, int(byteOf(last, k))));
  }
}

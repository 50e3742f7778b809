// Builds the geometry of contour points: the four vertices of a point, the wall to the next point and, for one point of
// each square, the faces into which contours divide the square. One invocation per point.
#include "common/words.glsl"
#include "contour/samples.glsl"
#include "grid/field.glsl"
#include "contour/squares.glsl"
#include "contour/vertices.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(classesBinding, ClassBlock, classes)
INPUT_WORDS(squaresBinding, SquareBlock, squares)
layout(std430, binding = normalsBinding) restrict writeonly buffer NormalBlock { vec4 normals[]; };
layout(std430, binding = indicesBinding) restrict writeonly buffer IndexBlock { uint indices[]; };
layout(std430, binding = nextPointsBinding) restrict writeonly buffer NextBlock { uint nextPoints[]; };
uniform float levels[LEVELS];
uniform uint firstPoint;    // Index of the first vertex of the first point
uniform uint pointRoom;
uniform uint sheetIndices;  // Number of indices per uniform square (four corners of one class)
#include "contour/points.glsl"
#include "contour/faces.glsl"

int classAt(ivec2 at) {
  if (at.x >= samples.x) return outside;
  return int(byteOf(LOAD_INPUT_WORDS(classes, at.y * rowElements + (at.x >> 4)), at.x & 15));
}

void main() {
  uint me = gl_GlobalInvocationID.x;
  if (me >= min(draw.points, pointRoom)) return;
  uvec4 square = LOAD_INPUT_WORDS(squares, int(me));
  ivec2 at = ivec2(square.x % uint(samples.x), square.x / uint(samples.x));
  Corners q = Corners(classAt(at), classAt(at + ivec2(1, 0)), classAt(at + ivec2(1, 1)), classAt(at + ivec2(0, 1)));
  Ranks ranks;
  ranks.top = square.y;
  ranks.left = ranks.top + uint(crossingsBetween(q.a, q.b));
  ranks.right = ranks.left + uint(crossingsBetween(q.a, q.d) + crossingsBetween(q.b, classAt(at + ivec2(2, 0))));
  ranks.bottom = square.z;
  // Finds the edge on which the point is. It is the edge along which the walk falls across the level.
  int side = 3, low = q.a;
  for (int i = 0; i < 3; ++i) {
    int here = cornerClass(q, i), next = cornerClass(q, i + 1);
    uint first = edgeRank(ranks, i);
    bool mine = here > next && me >= first && me < first + uint(here - next);
    side = mine ? i : side;
    low = mine ? next : low;
  }
  int level = int(me - edgeRank(ranks, side)) + low + 1;
  bool across = (side & 1) == 0;
  ivec2 start = at + ivec2(side == 1 ? 1 : 0, side == 2 ? 1 : 0);
  // Edges run from left to right and from top to bottom. The walk passes the third and fourth side in the opposite
  // direction.
  putPoint(me, start, across ? ivec2(1, 0) : ivec2(0, 1), level, side >= 2);
  putWall(fixedIndices + sheetIndices * draw.sheets, me, nextPoint(q, ranks, level, side));
  if (square.w != nowhere) faces(q, ranks, at, square.w);
}

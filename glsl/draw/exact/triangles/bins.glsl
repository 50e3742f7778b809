// Triangles listed by the tiles of the picture that they meet, for software drivers, whose atomics cost more than all
// the rest: each tile is then one group's alone (binned.comp). A list has nodes of the next node and a triangle, numbers that
// count from 1; triangles keep their corners, three texels each. Of very many, each `roundTriangles` have lists of their own,
// so that no loop ends early; so have the faces of lamps' maps.
#include "draw/exact/bindings.glsl"
// Words before the lists' heads: how many shared nodes are taken, how many triangles are listed, how many tiles have some, by
// round, and how many triangles are listed of each face of maps.
const int binCounts = 512;
const int firstTileCount = 2, firstFaceCount = 256;
const int binTexels = 3;
const uint ownNodes = 4u;  // of each triangle, before those that all share
#ifdef MAKES_BINS
layout(std430, binding = binBinding) restrict buffer BinBlock { uint bins[]; };
layout(std430, binding = nodeBinding) writeonly restrict buffer NodeBlock { uvec2 nodes[]; };
layout(std430, binding = cornerBinding) writeonly restrict buffer CornerBlock { uvec4 binned[]; };
uniform int binTiles;  // of the picture
uniform int roundTriangles;
#ifdef LAMP_MAP
uniform int face;
#endif
uniform int faceRounds;  // of the picture, or of each face,
uniform int rounds;      // and of all
uniform int cornerRoom;       // triangles
uniform int sharedNodes;      // how many,
uniform uint firstSharedNode;

// False where there is no room for all of it, and of those too large for the arithmetic of binned.comp or for a loop.
bool bin(Triangle t, uint id) {
  ivec2 first = max(t.low / subpixels, ivec2(0, PICTURE_ROWS.x)) / tileSide;
  ivec2 last = min(t.high / subpixels, ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y) - 1) / tileSide;
  ivec2 box = max(last - first + 1, ivec2(0)), longest = t.high - t.low;
  if (max(longest.x, longest.y) > 8192 * subpixels || box.x * box.y > 16384) return false;
  int number = int(atomicAdd(bins[1], 1u));
  if (number >= cornerRoom) return false;
#ifdef LAMP_MAP
  int round_ = int(atomicAdd(bins[firstFaceCount + face], 1u)) / roundTriangles;
#else
  const int face = 0;
  int round_ = number / roundTriangles;
#endif
  if (round_ >= faceRounds) return false;
  round_ += face * faceRounds;
  ivec2 a = t.edges[0].from, b = t.edges[1].from, c = t.edges[2].from;
  binned[number * binTexels] = uvec4(a, b);
  binned[number * binTexels + 1] = uvec4(c, id, uint(floatBitsToInt(t.near)));
  binned[number * binTexels + 2] = floatBitsToUint(vec4(t.acrossNear, t.downNear, t.least, t.most));
  int columns = (PICTURE_SIZE.x + tileSide - 1) / tileSide, firstRow = PICTURE_ROWS.x / tileSide;
  int end = t.high.x < 0 || t.high.y < 0 ? -1 : last.y;
  Crossing ca = crossingOf(t.edges[0]), cb = crossingOf(t.edges[1]), cc = crossingOf(t.edges[2]);
  uint count = 0u;
  bool room = true;
  for (int y = first.y; y <= end; ++y) {
    ivec2 span = ivec2(first.x, last.x);
    span = tilesBetween(span, t.edges[0], ca, y);
    span = tilesBetween(span, t.edges[1], cb, y);
    span = tilesBetween(span, t.edges[2], cc, y);
    for (int x = span.x; x <= span.y; ++x) {
      int tile = round_ * binTiles + (y - firstRow) * columns + x;
      uint node = uint(number) * ownNodes + count;
      if (count >= ownNodes) node = firstSharedNode + atomicAdd(bins[0], 1u);
      room = room && node < firstSharedNode + uint(sharedNodes);
      ++count;
      if (room) {
        uint before = atomicExchange(bins[binCounts + tile], node + 1u);
        nodes[node] = uvec2(before, uint(number));
        int list = binCounts + (rounds + round_) * binTiles;
        if (before == 0u) bins[list + int(atomicAdd(bins[firstTileCount + round_], 1u))] = uint(tile);
      }
    }
  }
  return room;
}
#endif

// Lists of triangles by picture tile, for software drivers, on which atomics cost more than everything else. One
// workgroup rasterizes each tile (binned.comp). A list consists of nodes (index of the next node, index of the
// triangle); node indices start at 1. The corners of a triangle take three texels. Each group of `roundTriangles`
// triangles (a round) has separate lists, so that no loop gets too long. Each shadow map face has separate lists, too.
#include "draw/exact/bindings.glsl"
// Number of words before the heads of the lists. The words hold: number of used shared nodes, number of listed
// triangles, number of non-empty tiles by round, and number of listed triangles by shadow map face.
const int binCounts = 512;
const int firstTileCount = 2, firstFaceCount = 256;
const int binTexels = 3;
const uint ownNodes = 4u;  // nodes reserved for each triangle; further nodes come from a shared pool
#ifdef MAKES_BINS
layout(std430, binding = binBinding) restrict buffer BinBlock { uint bins[]; };
layout(std430, binding = nodeBinding) writeonly restrict buffer NodeBlock { uvec2 nodes[]; };
layout(std430, binding = cornerBinding) writeonly restrict buffer CornerBlock { uvec4 binned[]; };
uniform int binTiles;  // number of tiles in the picture
uniform int roundTriangles;
#ifdef LAMP_MAP
uniform int face;
#endif
uniform int faceRounds;  // number of rounds of the picture or of each shadow map face
uniform int rounds;      // number of rounds of all faces together
uniform int cornerRoom;       // capacity of the corner buffer in triangles
uniform int sharedNodes;      // number of nodes in the shared pool
uniform uint firstSharedNode;

// Lists a triangle. Returns false if there is no room, or if the triangle is too large for binned.comp or for the loop
// in this function.
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
  binned[number * binTexels + 2] = floatBitsToUint(vec4(t.acrossNear, t.downNear, t.minimum, t.maximum));
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

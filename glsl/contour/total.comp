// Prefix sum, step 2 of 3: replaces each tile sum by the sum of all tiles before it, and writes the draw arguments from
// the total. Runs as a single workgroup, in which each invocation processes some of the tiles.
#include "common/words.glsl"
#include "contour/bindings.glsl"
#include "contour/types.glsl"
layout(local_size_x = 256) in;
STATE_WORDS(tileSumsBinding, TileBlock, tileSums)
layout(std430, binding = drawBinding) restrict writeonly buffer DrawBlock { ContourDraw draw; };
uniform int tiles;
uniform uint fixedIndices;   // Number of indices that do not change
uniform uint sheetIndices;   // Number of indices per uniform square
uniform uint pointIndices;   // Number of indices per contour point, not counting triangles
uniform uint pointRoom;      // Capacity in points; `indexRoom` is the capacity in indices
uniform uint indexRoom;
shared uvec4 sums[256];

void finish(uvec4 total) {
  uint indices = fixedIndices + sheetIndices * total.y + pointIndices * total.x + 3u * total.z;
  bool fits = total.x <= pointRoom && indices <= indexRoom;
  draw.count = fits ? indices : 0u;
  draw.instances = 1u;
  draw.firstIndex = 0u;
  draw.baseVertex = 0u;
  draw.baseInstance = 0u;
  draw.indices = indices;
  draw.points = total.x;
  draw.sheets = total.y;
  draw.triangles = total.z;
}

void main() {
  int each = (tiles + 255) / 256, me = int(gl_LocalInvocationIndex);
  int begin = me * each, end = min(begin + each, tiles);
  uvec4 sum = uvec4(0);
  for (int i = begin; i < end; ++i) sum += LOAD_WORDS(tileSums, i);
  sums[me] = sum;
  memoryBarrierShared();
  barrier();
  uvec4 before = uvec4(0);
  for (int i = 0; i < me; ++i) before += sums[i];
  for (int i = begin; i < end; ++i) {
    uvec4 mine = LOAD_WORDS(tileSums, i);
    STORE_WORDS(tileSums, i, before);
    before += mine;
  }
  if (me == 255) finish(before);
}

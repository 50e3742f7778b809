// Digs the corridors that the trees have chosen in this round into a copy of the cells. The border remains rock. One
// invocation per word of cells.
#define NO_LINKS  // dugBinding takes the binding point of the links
#include "common/exact.glsl"
#include "cave/trees.glsl"
#include "cave/corridor.glsl"
layout(std430, binding = dugBinding) restrict buffer DugBlock { uint dug[]; };
uniform int width;
uniform int firstStep;  // First step of the corridors that this dispatch digs; the number of steps per dispatch is
                        // limited, because software drivers end long loops
uniform int steps;

void digCell(ivec2 at) {
  if (at.x < 1 || at.y < 1 || at.x >= size.x - 1 || at.y >= size.y - 1) return;
  atomicAnd(dug[at.y * rowWords + (at.x >> 5)], ~(1u << uint(at.x & 31)));
}

void dig(ivec2 from, ivec2 to) {
  ivec2 way = to - from, amount = abs(way);
  bool wide = amount.x >= amount.y;
  int longer = wide ? amount.x : amount.y, shorter = wide ? amount.y : amount.x;
  ivec2 onward = ivec2(way.x < 0 ? -1 : 1, way.y < 0 ? -1 : 1);
  int end = min(longer, firstStep + steps - 1);
  for (int along = firstStep; along <= end; ++along) {
    CorridorCells c = corridorCells(along, longer, shorter, width);
    for (int across = c.first; across <= c.last; ++across)
      digCell(from + onward * (wide ? ivec2(along, across) : ivec2(across, along)));
  }
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  for (uint starts = openStarts(i); starts != 0u; starts &= starts - 1u) {
    uint tree = uint(32 * i + findLSB(starts));
    if (!isRoom(tree) || trees[tree] != tree || edges[tree] == nowhere) continue;
    uint edge = edges[tree], cell = edge >> 1u;
    uint next = cell + ((edge & 1u) == 0u ? 1u : 32u * uint(rowWords));
    dig(placeOf(sources[cell]), placeOf(sources[next]));
  }
}

// Computes one pass of a search for the nearest open cell (in L1 distance; among equal distances, the lowest cell).
// Each cell takes the best among its candidate and the candidates of the cells that are `reach` cells away. The passes
// use the distances 1, 2, 4, ... along rows, then along columns. The result is the nearest cell, because if an
// intermediate cell has kept another candidate, that candidate is at least as near.
#include "cave/cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = sourcesBinding) restrict readonly buffer SourceBlock { uint sources[]; };
layout(std430, binding = nextSourcesBinding) restrict writeonly buffer NextBlock { uint nextSources[]; };
uniform ivec2 reach;

void consider(ivec2 at, ivec2 other, inout uint best, inout int nearest) {
  if (other.x < 0 || other.y < 0 || other.x >= size.x || other.y >= size.y) return;
  uint source = sources[numberOf(other.x, other.y)];
  if (source == nowhere) return;
  ivec2 way = abs(placeOf(source) - at);
  int steps = way.x + way.y;
  if (steps > nearest || (steps == nearest && source >= best)) return;
  best = source;
  nearest = steps;
}

void main() {
  if (gl_GlobalInvocationID.x >= 32u * uint(rowWords)) return;
  uint cell = numberOf(int(gl_GlobalInvocationID.x), int(gl_GlobalInvocationID.y));
  ivec2 at = placeOf(cell);
  uint best = nowhere;
  int nearest = 0x7fffffff;
  consider(at, at, best, nearest);
  consider(at, at - reach, best, nearest);
  consider(at, at + reach, best, nearest);
  nextSources[cell] = best;
}

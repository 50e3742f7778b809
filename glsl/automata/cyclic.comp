// Computes one generation of a cyclic automaton: a cell takes the next state if at least THRESHOLD of its neighbours
// have that state. Defines: STATES, RANGE, THRESHOLD; DIAMOND for the neighbourhood |dx| + |dy| <= RANGE, otherwise it
// is the square of radius RANGE.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = bytesBinding) uniform usamplerBuffer paddedBytes;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int rowWords;
uniform int marginX;
#include "automata/output.glsl"

uint cellAt(int i) {
  return texelFetch(paddedBytes, i).x;
}

uint nextOf(int place) {
  uint state = cellAt(place);
  uint wanted = state + 1u == uint(STATES) ? 0u : state + 1u;
  int found = 0;
  for (int dy = -RANGE; dy <= RANGE; ++dy) {
#ifdef DIAMOND
    int reach = RANGE - abs(dy);
#else
    int reach = RANGE;
#endif
    for (int dx = -reach; dx <= reach; ++dx) found += cellAt(place + dy * rowWords * 4 + dx) == wanted ? 1 : 0;
  }
  return found >= THRESHOLD ? wanted : state;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= rowItems || at.y >= size.y) return;
  int place = (at.y + RANGE) * rowWords * 4 + marginX + at.x * CELLS;
  uvec4 block = uvec4(0u);
  for (int word = 0; word < CELLS / 4; ++word) {
    uint bytes = 0u;
    for (int j = 0; j < 4; ++j) bytes |= nextOf(place + word * 4 + j) << uint(8 * j);
    collect(block, word, bytes, size.x - at.x * CELLS - word * 4);
  }
  STORE_WORDS(newCells, at.y * rowItems + at.x, block);
}

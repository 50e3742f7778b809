// Computes one generation of a rule on nine cells. The rows are padded (automata/pad.comp), so edges need no special
// case. Defines: STATES; BITS if cells are stored as bits; MAP if `map` has a bit for every neighbourhood of live cells
// (state 1) and other states age; otherwise, the rule is a decision diagram over NEIGHBOURS neighbours.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = wordsBinding) uniform usamplerBuffer paddedWords;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;  // Number of cells per axis
uniform int rowItems;  // Number of elements per row of the next cells
uniform int rowWords;  // Number of words per padded row
uniform int marginX;
#include "automata/next.glsl"
#include "automata/output.glsl"

#ifdef MAP
uniform ivec4 map[4];

// Returns six bits that tell which cells are alive: the cell before a word, the four cells of the word, and the cell
// after it.
uint aliveSix(uvec3 words) {
  uint before = bytesOfOne(words.x) >> 24u;
  uint here = bytesOfOne(words.y) * 0x01020408u >> 24u & 15u;
  uint after = bytesOfOne(words.z) & 1u;
  return before | here << 1u | after << 5u;
}

uint nextFour(uvec3 above, uvec3 here, uvec3 below) {
  uint a = aliveSix(above);
  uint h = aliveSix(here);
  uint b = aliveSix(below);
  uint result = 0u;
  for (int j = 0; j < 4; ++j) {
    uint around = (a >> uint(j) & 7u) | (h >> uint(j) & 7u) << 3u | (b >> uint(j) & 7u) << 6u;
    bool holds = (uint(map[around >> 7u][around >> 5u & 3u]) >> (around & 31u) & 1u) != 0u;
    uint state = here.y >> uint(8 * j) & 255u;
    result |= agedState(state, holds, uint(STATES)) << uint(8 * j);
  }
  return result;
}
#else
layout(binding = treeBinding) uniform usamplerBuffer tree;
uniform int root;

// Returns the cell at the offset `column` (-1 to 4) from the first cell of a word.
uint cellOf(uvec3 words, int column) {
  return column < 0 ? words.x >> 24u : (column > 3 ? words.z & 255u : words.y >> uint(8 * column) & 255u);
}
uint child(uint node, uint state) {
  return texelFetch(tree, int(node + state)).x;
}

uint nextFour(uvec3 above, uvec3 here, uvec3 below) {
  uint result = 0u;
  for (int j = 0; j < 4; ++j) {
    uint node = uint(root);
#if NEIGHBOURS == 8
    node = child(node, cellOf(above, j - 1));
    node = child(node, cellOf(above, j + 1));
    node = child(node, cellOf(below, j - 1));
    node = child(node, cellOf(below, j + 1));
#endif
    node = child(node, cellOf(above, j));
    node = child(node, cellOf(here, j - 1));
    node = child(node, cellOf(here, j + 1));
    node = child(node, cellOf(below, j));
    result |= child(node, cellOf(here, j)) << uint(8 * j);
  }
  return result;
}
#endif

uint wordAt(int i) {
  return texelFetch(paddedWords, i).x;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= rowItems || at.y >= size.y) return;
  int place = at.y * rowWords + (marginX + at.x * CELLS) / 4;
  // Each variable holds the previous, the current and the next word of the row above, of this row, and of the row
  // below.
  uvec3 above = uvec3(0u, wordAt(place - 1), wordAt(place));
  uvec3 here = uvec3(0u, wordAt(place + rowWords - 1), wordAt(place + rowWords));
  uvec3 below = uvec3(0u, wordAt(place + 2 * rowWords - 1), wordAt(place + 2 * rowWords));
  uvec4 block = uvec4(0u);
  for (int word = 0; word < CELLS / 4; ++word) {
    int next = place + word + 1;
    above = uvec3(above.yz, wordAt(next));
    here = uvec3(here.yz, wordAt(next + rowWords));
    below = uvec3(below.yz, wordAt(next + 2 * rowWords));
    collect(block, word, nextFour(above, here, below), size.x - at.x * CELLS - word * 4);
  }
  STORE_WORDS(newCells, at.y * rowItems + at.x, block);
}

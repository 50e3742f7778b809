// Larger than Life with an arbitrary weighted neighbourhood, given as a list of offsets. An invocation processes
// sixteen cells together. A list item has two words: the offset (column + 512 in the lower ten bits, row + 512 above),
// then the weight. Defines: as for wide.glsl; FLIPPED negates the row offset in cells with odd column + row;
// STATE_WEIGHTS means that a weight per state follows the list, otherwise only state 1 counts, with weight 1.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = wordsBinding) uniform usamplerBuffer paddedWords;
layout(binding = treeBinding) uniform usamplerBuffer list;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int rowWords;
uniform int marginX;
uniform int range;  // Number of padded rows above the grid
uniform int places;  // Number of list items
#include "automata/wide.glsl"
#include "automata/sixteen.glsl"

#ifdef STATE_WEIGHTS
int stateWeight(uint state) {
  return int(texelFetch(list, 2 * places + int(state)).x);
}
ivec4 counted(uint bytes) {
  return ivec4(stateWeight(bytes & 255u), stateWeight(bytes >> 8u & 255u), stateWeight(bytes >> 16u & 255u),
               stateWeight(bytes >> 24u));
}
#else
ivec4 counted(uint bytes) {
  uint ones = bytesOfOne(bytes);
  return ivec4(uvec4(ones, ones >> 8u, ones >> 16u, ones >> 24u) & 255u);
}
#endif

// Returns sixteen consecutive bytes, starting at byte `from`.
uvec4 sixteenFrom(int from) {
  uint shift = uint(from & 3) * 8u;
  int word = from >> 2;
  uint w0 = texelFetch(paddedWords, word).x, w1 = texelFetch(paddedWords, word + 1).x;
  uint w2 = texelFetch(paddedWords, word + 2).x, w3 = texelFetch(paddedWords, word + 3).x;
  if (shift == 0u) return uvec4(w0, w1, w2, w3);
  uint w4 = texelFetch(paddedWords, word + 4).x;
  return uvec4(w0, w1, w2, w3) >> shift | uvec4(w1, w2, w3, w4) << (32u - shift);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  bool inside = at.x / LANES < rowItems && at.y < size.y;
  uvec4 bytes = uvec4(0u);
  if (inside) {
    int row = rowWords * 4;
    int first = (at.y + range) * row + marginX + at.x * 16;
    ivec4 total0 = ivec4(0), total1 = ivec4(0), total2 = ivec4(0), total3 = ivec4(0);
    for (int i = 0; i < places; ++i) {
      int where = int(texelFetch(list, 2 * i).x);
      int weight = int(texelFetch(list, 2 * i + 1).x);
      int dx = (where & 1023) - 512, dy = (where >> 10) - 512;
      uvec4 around = sixteenFrom(first + dy * row + dx);
#ifdef FLIPPED
      uint even = (at.y & 1) == 0 ? 0x00ff00ffu : 0xff00ff00u;  // Mask of those of the four cells that have even x + y
      around = around & even | sixteenFrom(first - dy * row + dx) & ~even;
#endif
      total0 += weight * counted(around.x);
      total1 += weight * counted(around.y);
      total2 += weight * counted(around.z);
      total3 += weight * counted(around.w);
    }
    for (int i = 0; i < 4; ++i) {
      uint here = texelFetch(paddedWords, first / 4 + i).x;
      ivec4 total = i == 0 ? total0 : i == 1 ? total1 : i == 2 ? total2 : total3;
      for (int j = 0; j < 4; ++j) bytes[i] |= wideNext(here >> uint(8 * j) & 255u, total[j]) << uint(8 * j);
    }
  }
  storeSixteen(bytes, size.x - at.x * 16, at.y * rowItems + at.x / LANES, inside);
}

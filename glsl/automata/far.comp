// Larger than Life with wide ranges, last pass: computes the sum over each row around a cell as a difference of prefix
// sums from row_sums.comp or window_sums.comp. The running sums of spans.comp cannot be used, because they start with a
// loop over the whole neighbourhood, which exceeds a software driver's iteration limit. Defines: as for wide.glsl;
// ROWS, the number of rows around a cell; LEFTS and RIGHTS, the column offsets of the first and last cell of each row.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = wordsBinding) uniform usamplerBuffer paddedWords;
layout(binding = sumsBinding) uniform usamplerBuffer sums;
STATE_WORDS(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int rowWords;
uniform int marginX;
uniform int range;  // Number of padded rows above the grid
#include "automata/wide.glsl"
#include "automata/sixteen.glsl"
const int lefts[ROWS] = int[](LEFTS);
const int rights[ROWS] = int[](RIGHTS);

ivec4 sumsAt(int i) {
  return ivec4(texelFetch(sums, i).x, texelFetch(sums, i + 1).x, texelFetch(sums, i + 2).x, texelFetch(sums, i + 3).x);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  bool inside = at.x / LANES < rowItems && at.y < size.y;
  uvec4 bytes = uvec4(0u);
  if (inside) {
    int row = rowWords * 4;
    int first = at.y * row + marginX + at.x * 16;
    ivec4 total0 = ivec4(0), total1 = ivec4(0), total2 = ivec4(0), total3 = ivec4(0);
    for (int i = 0; i < ROWS; ++i) {
      int end = first + i * row + rights[i];
      int before = first + i * row + lefts[i] - 1;
      total0 += sumsAt(end) - sumsAt(before);
      total1 += sumsAt(end + 4) - sumsAt(before + 4);
      total2 += sumsAt(end + 8) - sumsAt(before + 8);
      total3 += sumsAt(end + 12) - sumsAt(before + 12);
    }
    int place = (at.y + range) * rowWords + marginX / 4 + at.x * 4;
    for (int i = 0; i < 4; ++i) {
      uint here = texelFetch(paddedWords, place + i).x;
      ivec4 total = i == 0 ? total0 : i == 1 ? total1 : i == 2 ? total2 : total3;
      for (int j = 0; j < 4; ++j) bytes[i] |= wideNext(here >> uint(8 * j) & 255u, total[j]) << uint(8 * j);
    }
  }
  storeSixteen(bytes, size.x - at.x * 16, at.y * rowItems + at.x / LANES, inside);
}

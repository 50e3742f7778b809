// Larger than Life with wide ranges, first pass: computes inclusive prefix sums of the cells in state 1 along each
// padded row. One invocation per row, which processes four cells at a time.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 32) in;
INPUT_WORDS(paddedBinding, PaddedBlock, padded)
STATE_WORDS(sumsBinding, SumBlock, sums)
uniform int rows;
uniform int paddedItems;
#include "automata/next.glsl"

void main() {
  int y = int(gl_GlobalInvocationID.x);
  if (y >= rows) return;
  uint before = 0u;
  for (int i = 0; i < paddedItems; ++i) {
    uvec4 item = LOAD_INPUT_WORDS(padded, y * paddedItems + i);
    for (int word = 0; word < 4; ++word) {
      uint ones = bytesOfOne(item[word]);
      // The multiplication makes byte j the sum of the bytes 0 to j.
      uint upTo = ones * 0x01010101u;
      uvec4 four = (uvec4(upTo, upTo >> 8u, upTo >> 16u, upTo >> 24u) & 255u) + before;
      STORE_WORDS(sums, (y * paddedItems + i) * 4 + word, four);
      before = four.w;
    }
  }
}

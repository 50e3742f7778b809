// Larger than Life with squares, first pass: counts the live cells among the 2 RANGE + 1 cells of a column around each
// cell. An invocation moves down ROWS rows of 16 columns, one byte per column, and in each step adds one row and
// subtracts one row. A sum is at most 255, so it fits in a byte. Defines: STATES, RANGE, ROWS.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
INPUT_WORDS(paddedBinding, PaddedBlock, padded)
STATE_WORDS(sumsBinding, SumBlock, sums)
uniform int height;  // Height of the grid in cells
uniform int paddedItems;
#include "automata/next.glsl"

uvec4 living(int row, int x) {
  uvec4 bytes = LOAD_INPUT_WORDS(padded, row * paddedItems + x);
#if STATES > 2
  bytes = uvec4(bytesOfOne(bytes.x), bytesOfOne(bytes.y), bytesOfOne(bytes.z), bytesOfOne(bytes.w));
#endif
  return bytes;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  int top = at.y * ROWS;
  if (at.x >= paddedItems || top >= height) return;
  // Row y of the grid is stored as row y + RANGE of the padded cells.
  uvec4 sum = uvec4(0u);
  for (int i = 0; i < 2 * RANGE; ++i) sum += living(top + i, at.x);
  int end = min(top + ROWS, height);
  for (int y = top; y < end; ++y) {
    sum += living(y + 2 * RANGE, at.x);
    STORE_WORDS(sums, y * paddedItems + at.x, sum);
    sum -= living(y, at.x);
  }
}

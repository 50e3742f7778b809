// Larger than Life with wide squares, second pass: sums the prefix sums of row_sums.comp over the 2 RANGE + 1 rows
// around each row. An invocation computes running sums down ROWS rows of four columns. Defines: RANGE, ROWS.
#include "common/words.glsl"
#include "automata/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
INPUT_WORDS(rowSumsBinding, RowSumBlock, rowSums)
STATE_WORDS(sumsBinding, SumBlock, sums)
uniform int height;  // Height of the grid in cells
uniform int paddedItems;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  int top = at.y * ROWS;
  int row = paddedItems * 4;
  if (at.x >= row || top >= height) return;
  uvec4 sum = uvec4(0u);
  for (int i = 0; i < 2 * RANGE; ++i) sum += LOAD_INPUT_WORDS(rowSums, (top + i) * row + at.x);
  int end = min(top + ROWS, height);
  for (int y = top; y < end; ++y) {
    sum += LOAD_INPUT_WORDS(rowSums, (y + 2 * RANGE) * row + at.x);
    STORE_WORDS(sums, y * row + at.x, sum);
    sum -= LOAD_INPUT_WORDS(rowSums, y * row + at.x);
  }
}

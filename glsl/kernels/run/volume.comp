// Packs the values of a user's volume into rows of floats for its level surface (volume/values.glsl): first all values,
// then all numbers that colour the surface. One invocation per element of four cells.
#include "common/memory.glsl"
#include "common/words.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, CellBlock, cells)  // x: value; w: number that selects the colour
STATE_WORDS(1, VolumeBlock, volumeWords)
uniform int width;    // number of cells per row
uniform int columns;  // number of elements per row
uniform int rows;     // number of rows in all layers

void main() {
  int i = int(gl_GlobalInvocationID.x), all = columns * rows;
  if (i >= 2 * all) return;
  int element = i % all, first = element % columns * 4, row = element / columns;
  uvec4 four = uvec4(0u);
  for (int c = 0; c < 4; ++c) {
    if (first + c >= width) continue;
    vec4 cell = LOAD_INPUT(cells, row * width + first + c);
    four[c] = floatBitsToUint(i < all ? cell.x : cell.w);
  }
  STORE_WORDS(volumeWords, i, four);
}

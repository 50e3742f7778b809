// The main function of a step; the kernel that includes it gives
//   uvec4 stepElement(ivec2 at, Row above, Row here, Row below)   the sixteen cells at element column at.x, row at.y
#ifdef TEXEL_PATH
layout(local_size_x = 8, local_size_y = 1) in;
const int rowsEach = 16;
#else
layout(local_size_x = 8, local_size_y = 16) in;
const int rowsEach = 4;
#endif

void main() {
  int c = int(gl_GlobalInvocationID.x);
  int first = int(gl_GlobalInvocationID.y) * rowsEach;
  int end = c < rowElements() ? min(first + rowsEach, size.y) : first;
  uint ready = 0u, spreading = 0u, spent = 0u;
  if (first < end) {
    Column column = columnOf(c);
    Row above = loadRow(column, first - 1);
    Row here = loadRow(column, first);
    for (int y = first; y < end; ++y) {
      Row below = loadRow(column, y + 1);
      uvec4 next = stepElement(ivec2(c, y), above, here, below);
      STORE_WORDS(nextCells, y * rowElements() + c, next);
      ready += sumOfWords(readyCells(next));
      spreading += sumOfWords(activeCells(next));
      spent += sumOfWords(spentCells(next));
      above = here;
      here = below;
    }
  }
  count(ready, spreading, spent, max(end - first, 0), c);
}

// Computes one smoothing step of the automaton. One invocation per word of 32 cells.
#include "cave/cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = nextCellsBinding) restrict writeonly buffer NextBlock { uint nextCells[]; };

BitSum rowAt(int column, int y) {
  return rowSum(rockAt(column - 1, y), rockAt(column, y), rockAt(column + 1, y));
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords, column = i - y * rowWords;
  uint word = mostlyRock(rowAt(column, y - 1), rowAt(column, y), rowAt(column, y + 1));
  uint border = ~validBits(column);
  if (y == 0 || y == size.y - 1) border = ~0u;
  if (column == 0) border |= 1u;
  if (column == (size.x - 1) >> 5) border |= 1u << uint((size.x - 1) & 31);
  nextCells[i] = word | border;
}

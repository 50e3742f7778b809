// Packs the distances at the eight corners of each cell into one element. One invocation per cell.
#include "collide/distance/kernel.glsl"
STATE_WORDS(cellsBinding, CellBlock, cells)
uniform int firstCell;

int at(int i) {
  return int(LOAD_WORDS(searches, i).x);
}

uint pairAt(int i) {
  return halves(at(i), at(i + 1));
}

void main() {
  ivec3 size = nodes.xyz - 1;
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y * size.z) return;
  int rest = i / size.x, slice = nodes.x * nodes.y;
  int node = ((rest / size.y) * nodes.y + rest % size.y) * nodes.x + i % size.x;
  STORE_WORDS(cells, firstCell + i, uvec4(pairAt(node), pairAt(node + nodes.x), pairAt(node + slice), pairAt(node + slice + nodes.x)));
}

// Part common to the kernels that loop over rooms. One invocation per word of cells.
#include "cave/ways.glsl"
layout(local_size_x = 64) in;

uint openStarts(int i) {
  uint open = ~cells[i] & validBits(i % rowWords);
  return open & ~(open << 1u);
}
// Returns true if the cell identifies a room.
bool isRoom(uint cell) {
  return labels[cell] == cell;
}

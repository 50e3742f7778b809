// Common part of the kernels that loop over rooms: one word of cells per invocation.
#include "cave/ways.glsl"
layout(local_size_x = 64) in;

uint openStarts(int i) {
  uint open = ~cells[i] & validBits(i % rowWords);
  return open & ~(open << 1u);
}
// True if the cell identifies a room.
bool isRoom(uint cell) {
  return labels[cell] == cell;
}

// For kernels that go through the rooms: an invocation a word.
#include "cave/ways.glsl"
layout(local_size_x = 64) in;

uint openStarts(int i) {
  uint open = ~cells[i] & validBits(i % rowWords);
  return open & ~(open << 1u);
}
// Whether this cell names a room.
bool isRoom(uint cell) {
  return labels[cell] == cell;
}

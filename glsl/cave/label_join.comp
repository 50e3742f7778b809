// Joins runs that touch: both get the lower of their regions. A label never increases and never leaves its region. If
// this kernel is repeated until nothing changes, each label is the lowest cell of its region, whatever the order of the
// atomics (Shiloach and Vishkin, "An O(log n) parallel connectivity algorithm", 1982, with minima instead of stars).
#include "cave/runs.glsl"
layout(local_size_x = 64) in;

void join(uint a, uint b) {
  uint first = labels[labels[a]], second = labels[labels[b]];
  if (first == second) return;
  atomicMin(labels[max(first, second)], min(first, second));
  changed = 1u;
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rowWords * size.y) return;
  int y = i / rowWords, column = i - y * rowWords;
  uint here = kindAt(column, y), left = kindAt(column - 1, y), above = kindAt(column, y - 1);
#ifdef ROCK
  uint aboveLeft = kindAt(column - 1, y - 1), aboveRight = kindAt(column + 1, y - 1);
#endif
  for (uint starts = startsOf(here); starts != 0u; starts &= starts - 1u) {
    int begin = findLSB(starts), end = endOf(here, begin);
    uint run = uint(32 * i + begin);
    // The minimum is atomic, because a plain store could overwrite another invocation's result in every round.
    atomicMin(labels[run], labels[labels[run]]);
    if (begin == 0 && (left >> 31u) != 0u) join(run, uint(32 * (i - 1) + startOf(left, 31)));
    uint reach = bitsOf(begin, end);
#ifdef ROCK
    reach |= (reach << 1u) | (reach >> 1u);
    if (begin == 0 && (aboveLeft >> 31u) != 0u) join(run, uint(32 * (i - rowWords - 1) + startOf(aboveLeft, 31)));
    if (end == 32 && (aboveRight & 1u) != 0u) join(run, uint(32 * (i - rowWords + 1)));
#endif
    for (uint met = startsOf(above & reach); met != 0u; met &= met - 1u)
      join(run, uint(32 * (i - rowWords) + startOf(above, findLSB(met))));
  }
}

// The next place of a list whose counter that is. BALLOT: a subgroup's invocations take theirs together, since a card's
// atomics on one word stand in line.
#ifdef BALLOT
uint nextPlace(int counter) {
  uvec4 these = subgroupBallot(true);
  uint first = 0u;
  if (subgroupElect()) first = atomicAdd(counters[counter], subgroupBallotBitCount(these));
  return subgroupBroadcastFirst(first) + subgroupBallotExclusiveBitCount(these);
}
#else
uint nextPlace(int counter) {
  return atomicAdd(counters[counter], 1u);
}
#endif

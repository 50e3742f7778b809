// The next place of a list whose counter that is. BALLOT: a subgroup's invocations take theirs together, since a card's
// atomics on one word stand in line.
#ifdef BALLOT
uint nextPlace(int counter) {
  uvec4 these = subgroupBallot(true);
  uint first = 0u;
  if (subgroupElect()) first = atomicAdd(counters[counter], subgroupBallotBitCount(these));
  uint all_ = subgroupBroadcastFirst(first), before = subgroupBallotExclusiveBitCount(these);
  all_ += before;
  return all_;
}
#else
uint nextPlace(int counter) {
  return atomicAdd(counters[counter], 1u);
}
#endif

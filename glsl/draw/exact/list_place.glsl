// Reserves the next entry of a list and returns its index. `counter` is the index of the list's counter. BALLOT: the
// invocations of a subgroup reserve their entries with a single atomic, because a GPU serializes atomics on the same
// word.
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

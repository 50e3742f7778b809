// Regions by runs: neighbouring cells of one kind within a word are one run, named by its first cell, and a region is
// named by its lowest cell, which begins a run. ROCK: regions of rock, joined over corners too; else of open cells,
// joined over edges.
#include "cave/cells.glsl"
layout(std430, binding = labelsBinding) restrict buffer LabelBlock { uint labels[]; };
layout(std430, binding = tallyBinding) restrict buffer TallyBlock { uint tally[]; };
layout(std430, binding = flagsBinding) restrict buffer FlagBlock {
  uint changed;
  uint greatest;  // cells of a region
  uint first;     // the lowest of those that have so many
  uint spareFlag;
};

// Of the kind that is looked at; nothing lies outside.
uint kindAt(int column, int y) {
  if (column < 0 || column >= rowWords || y < 0 || y >= size.y) return 0u;
#ifdef ROCK
  return cells[y * rowWords + column] & validBits(column);
#else
  return ~cells[y * rowWords + column] & validBits(column);
#endif
}

uint startsOf(uint word) {
  return word & ~(word << 1u);
}
// Where the run ends that begins at `bit`: one after its last.
int endOf(uint word, int bit) {
  uint gaps = ~word & (~0u << uint(bit));
  return gaps == 0u ? 32 : findLSB(gaps);
}
// Where the run begins that `bit` lies in.
int startOf(uint word, int bit) {
  return findMSB(~word & ((1u << uint(bit)) - 1u)) + 1;
}
uint bitsOf(int begin, int end) {
  return (~0u << uint(begin)) & (~0u >> uint(32 - end));
}

// Regions as sets of runs. A run is a sequence of adjacent cells of one kind within a word, identified by its first
// cell. A region is identified by its lowest cell, at which a run begins. If ROCK is defined, the regions are rock,
// connected over edges and corners; otherwise they are open cells, connected over edges.
#include "cave/cells.glsl"
layout(std430, binding = labelsBinding) restrict buffer LabelBlock { uint labels[]; };
layout(std430, binding = tallyBinding) restrict buffer TallyBlock { uint tally[]; };
layout(std430, binding = flagsBinding) restrict buffer FlagBlock {
  uint changed;
  uint greatest;  // Number of cells in the largest region
  uint first;     // Lowest cell of all regions of this size
  uint spareFlag;
};

// Returns a word whose set bits are cells of the kind of the regions. It is 0 outside the grid.
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
// Returns the end of the run that begins at `bit`: one past the run's last bit.
int endOf(uint word, int bit) {
  uint gaps = ~word & (~0u << uint(bit));
  return gaps == 0u ? 32 : findLSB(gaps);
}
// Returns the first bit of the run that contains `bit`.
int startOf(uint word, int bit) {
  return findMSB(~word & ((1u << uint(bit)) - 1u)) + 1;
}
uint bitsOf(int begin, int end) {
  return (~0u << uint(begin)) & (~0u >> uint(32 - end));
}

// Connections between rooms. A connection leads from the open cell nearest to one cell to the open cell nearest to an
// adjacent cell, across the edge between these two cells. The minimum spanning tree is found among these connections
// (Mehlhorn, "A faster approximation algorithm for the Steiner problem in graphs", 1988). The edge to the right of a
// cell has the index 2 cell, the edge below it 2 cell + 1.
#include "cave/cells.glsl"
layout(std430, binding = labelsBinding) restrict readonly buffer LabelBlock { uint labels[]; };
layout(std430, binding = tallyBinding) restrict buffer TreeBlock { uint trees[]; };  // Tree of each room
layout(std430, binding = flagsBinding) restrict buffer FlagBlock { uint joined; };
layout(std430, binding = sourcesBinding) restrict readonly buffer SourceBlock { uint sources[]; };
layout(std430, binding = weightsBinding) restrict buffer WeightBlock { uint weights[]; };
layout(std430, binding = edgesBinding) restrict buffer EdgeBlock { uint edges[]; };
#ifndef NO_LINKS
layout(std430, binding = linksBinding) restrict buffer LinkBlock { uint links[]; };
#endif

// Returns the run of an open cell, identified by the run's first cell. Corridors that were dug since the labelling do
// not turn open cells into rock.
uint runOf(uint cell) {
  uint rock = cells[cell >> 5u];
  uint bit = cell & 31u;
  return (cell & ~31u) + uint(findMSB(rock & ((1u << bit) - 1u)) + 1);
}

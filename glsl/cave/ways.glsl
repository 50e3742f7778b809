// Between the rooms. A way leads from the open cell nearest to one cell to the open cell nearest to the next, over the
// edge between the two; the tree of shortest ways is found among these (Mehlhorn, "A faster approximation algorithm for
// the Steiner problem in graphs", 1988). Edges are numbered 2 cell + 1 downwards, 2 cell to the right.
#include "cave/cells.glsl"
layout(std430, binding = labelsBinding) restrict readonly buffer LabelBlock { uint labels[]; };
layout(std430, binding = tallyBinding) restrict buffer TreeBlock { uint trees[]; };  // of rooms
layout(std430, binding = flagsBinding) restrict buffer FlagBlock { uint joined; };
layout(std430, binding = sourcesBinding) restrict readonly buffer SourceBlock { uint sources[]; };
layout(std430, binding = weightsBinding) restrict buffer WeightBlock { uint weights[]; };
layout(std430, binding = edgesBinding) restrict buffer EdgeBlock { uint edges[]; };
#ifndef NO_LINKS
layout(std430, binding = linksBinding) restrict buffer LinkBlock { uint links[]; };
#endif

// An open cell's run is named by its first cell; corridors dug meanwhile make no cell rock.
uint runOf(uint cell) {
  uint rock = cells[cell >> 5u];
  uint bit = cell & 31u;
  return (cell & ~31u) + uint(findMSB(rock & ((1u << bit) - 1u)) + 1);
}

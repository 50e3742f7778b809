// Tiles of 4x4 blocks, where a block is 2x2 cells. A workgroup of 8x8 invocations processes four tiles from a list in
// `weights` (FluidLevels::tileLists), which holds either the open tiles (if IN_THE_OPEN is defined) or the other tiles.
// In an open tile, all faces up to four cells away are fully open and all cell distances are 1, so that kernels need no
// weights.
const int groupRow = 64;  // Workgroups in a full row of the dispatch

int groupNumber() {
  return int(gl_WorkGroupID.y) * groupRow + int(gl_WorkGroupID.x);
}

// Returns the block of this invocation in the workgroup's four tiles of the list that starts at `tilesStart`. If there
// is no tile, returns a block beyond the grid.
ivec2 blockHere(int tilesStart) {
  ivec2 lane = ivec2(gl_LocalInvocationID.xy);
  uvec4 four = LOAD_INPUT_WORDS(weights, tilesStart + groupNumber());
  uint tile = lane.y < 4 ? (lane.x < 4 ? four.x : four.y) : (lane.x < 4 ? four.z : four.w);
  return 4 * ivec2(tile & 0xffffu, tile >> 16u) + (lane & 3);
}

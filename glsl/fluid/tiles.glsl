// Work groups of 8x8 that take four tiles each of 4x4 blocks of 2x2 cells, from lists in `weights` (FluidLevels::tileLists): those in the
// open (IN_THE_OPEN), where up to four cells away all faces are open and a distance of 1 apart, or the others.
const int groupRow = 64;  // groups along x where there are as many

int groupNumber() {
  return int(gl_WorkGroupID.y) * groupRow + int(gl_WorkGroupID.x);
}

// The block of this invocation, in one of its group's four tiles of the list at `tilesStart`; beyond all of them where there is no tile.
ivec2 blockHere(int tilesStart) {
  ivec2 lane = ivec2(gl_LocalInvocationID.xy);
  uvec4 four = LOAD_INPUT_WORDS(weights, tilesStart + groupNumber());
  uint tile = lane.y < 4 ? (lane.x < 4 ? four.x : four.y) : (lane.x < 4 ? four.z : four.w);
  return 4 * ivec2(tile & 0xffffu, tile >> 16u) + (lane & 3);
}

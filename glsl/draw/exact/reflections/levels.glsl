// Memory layout of a mip pyramid in one buffer. Level 0 is on the left; the other levels are stacked to the right of
// it. A row is one and a half times as wide as level 0. The sides of level 0 are rounded up to whole cells of the last
// level. Compiles as GLSL and as C++.
#ifndef EXACT_LEVELS
#define EXACT_LEVELS
const int lastLevel = 5;

FUNCTION ivec2 levelRoom(ivec2 size) {
  return ((size + ((1 << lastLevel) - 1)) >> lastLevel) << lastLevel;
}

FUNCTION ivec2 levelSize(ivec2 size, int level) {
  return (size + ((1 << level) - 1)) >> level;
}

// Returns the buffer index of a cell. `room` is the result of levelRoom() for level 0.
FUNCTION int levelPlace(ivec2 room, int level, ivec2 at) {
  int down = level > 0 ? room.y - (room.y >> (level - 1)) : 0;
  int right = level > 0 ? room.x : 0;
  return (at.y + down) * (room.x + (room.x >> 1)) + at.x + right;
}

// Returns the number of buffer elements of all levels, including the gaps between levels.
FUNCTION int levelCells(ivec2 room) {
  return room.y * (room.x + (room.x >> 1));
}
#endif

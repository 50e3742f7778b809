// Where pictures of half the size of the one before lie in memory, level by level: level 0 to the left, the others beside it, one
// below the other. Rows are once and a half as wide as level 0, whose sides are whole cells of the last level. Compiles as GLSL
// and as C++.
#ifndef EXACT_LEVELS
#define EXACT_LEVELS
const int lastLevel = 5;

FUNCTION ivec2 levelRoom(ivec2 size) {
  return ((size + ((1 << lastLevel) - 1)) >> lastLevel) << lastLevel;
}

FUNCTION ivec2 levelSize(ivec2 size, int level) {
  return (size + ((1 << level) - 1)) >> level;
}

// `room`: levelRoom() of level 0.
FUNCTION int levelPlace(ivec2 room, int level, ivec2 at) {
  int down = level > 0 ? room.y - (room.y >> (level - 1)) : 0;
  int right = level > 0 ? room.x : 0;
  return (at.y + down) * (room.x + (room.x >> 1)) + at.x + right;
}
#endif

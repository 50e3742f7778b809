// Data of the solid with which cloth and particles collide, if WALLS is 1. Otherwise, nothing is bound or read.
#ifndef WALLS
#define WALLS 0
#endif
#if WALLS
#include "common/words.glsl"
#include "contour/wall_types.glsl"
const int fieldUnit = wallFieldUnit;
#include "grid/field.glsl"
uniform WallGrid wallGrid;
uniform int rowElements;  // Number of elements of sixteen classes per row
INPUT_WORDS(wallClassesBinding, WallClassBlock, wallClasses)

int loadWallClass(int x, int y) {
  uvec4 four = LOAD_INPUT_WORDS(wallClasses, y * rowElements + (x >> 4));
  uint word = (x & 8) == 0 ? ((x & 4) == 0 ? four.x : four.y) : ((x & 4) == 0 ? four.z : four.w);
  return int(word >> uint(8 * (x & 3)) & 255u);
}
float loadWallValue(int x, int y) {
  return valueAt(ivec2(x, y));
}
#include "contour/model.glsl"
#include "contour/wall_model.glsl"
#else
struct WallMotion {
  vec3 position;
  vec3 velocity;
};
WallMotion outOfWalls(vec3 from, vec3 to, vec3 velocity) {
  return WallMotion(to, velocity);
}
#endif

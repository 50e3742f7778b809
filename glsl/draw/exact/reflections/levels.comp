// A level of what reflections read (levels.glsl), of the one before. LIGHT: light of pixels and how much of them is covered, the mean
// of four; else nearness of half pixels, the most of four. FIRST: level 0, of what shading and occlusion have left.
#define EXACT_PICTURE
#include "common/once.glsl"
#include "common/exact.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/reflections/levels.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef LIGHT
#define CELL vec4
layout(rgba32f, binding = litImage) readonly restrict uniform imageBuffer before;
#ifdef FIRST
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
#endif
layout(std430, binding = halfPixelBinding) writeonly restrict buffer LevelBlock { vec4 cells[]; };
#else
#define CELL float
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer before;
layout(std430, binding = halfPixelBinding) writeonly restrict buffer LevelBlock { float cells[]; };
#endif
uniform ivec2 size;  // of level 0
uniform int level;
ivec2 room = levelRoom(size);

// Nothing beyond the border.
CELL cellBefore(ivec2 at) {
  ivec2 last = levelSize(size, level - 1) - 1;
  bool there = at.x <= last.x && at.y <= last.y;
#ifdef LIGHT
  return there ? imageLoad(before, levelPlace(room, level - 1, at)) : vec4(0.0f);
#else
  return there ? imageLoad(before, levelPlace(room, level - 1, at)).x : 0.0f;
#endif
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), end = levelSize(size, level);
  if (at.x >= end.x || at.y >= end.y) return;
#if defined FIRST && defined LIGHT
  cells[levelPlace(room, 0, at)] = imageLoad(sums, at);
#elif defined FIRST
  cells[levelPlace(room, 0, at)] = imageLoad(before, at.y * size.x + at.x).x;
#else
  CELL a = cellBefore(2 * at), b = cellBefore(2 * at + ivec2(1, 0));
  CELL c = cellBefore(2 * at + ivec2(0, 1)), d = cellBefore(2 * at + 1);
#ifdef LIGHT
  precise vec4 mean = 0.25f * ((a + b) + (c + d));
  cells[levelPlace(room, level, at)] = mean;
#else
  cells[levelPlace(room, level, at)] = max(max(a, b), max(c, d));
#endif
#endif
}

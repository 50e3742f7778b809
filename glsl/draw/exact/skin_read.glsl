// Materials grown from a field (draw/surface/skin.glsl), by reads of our own.
#include "draw/bindings.glsl"
#include "draw/exact/footprint.glsl"
#include "draw/surface/skin_values.glsl"
#include "draw/surface/skin_look.glsl"
layout(binding = reliefUnit) uniform sampler2D relief;
layout(binding = surroundingsUnit) uniform sampler2D surroundings;
uniform ivec2 reliefSize;
uniform int reliefLevels;
uniform vec2 skinCells;  // of the field

vec4 reliefTexel(int x, int y, int level) {
  return texelFetch(relief, ivec2(x, y), level);
}
FILTERED(vec4, reliefAt, reliefTexel)
float surroundingsTexel(int x, int y, int level) {
  return texelFetch(surroundings, ivec2(x, y), level).x;
}
FILTERED(float, surroundingsAt, surroundingsTexel)
#ifdef LOOK_MAP
layout(binding = skinColorUnit) uniform sampler2D skinColors;
vec3 skinColorTexel(int x, int y, int level) {
  return texelFetch(skinColors, ivec2(x, y), level).rgb;
}
FILTERED(vec3, skinColorAt, skinColorTexel)
#endif

SkinArea skinArea(Seen seen) {
  TextureShape shape = TextureShape(reliefSize, reliefLevels, true);
  Footprint print = footprintOf(seen, shape);
  vec4 mean = reliefAt(seen.at, print, shape);
  precise float spread = mean.y - mean.x * mean.x;
  precise float beyond = print.longer - 1.0f;
  // Between texels that a pixel does not even fill there is no variance, only interpolation.
  precise float variance = max(spread, 0.0f) * clamp(beyond, 0.0f, 1.0f);
  SkinArea area;
  area.q = mean.x;
  area.variance = variance;
  area.slope = mean.zw;
  area.around = surroundingsAt(seen.at, print, shape);
#ifdef LOOK_MAP
  area.color = skinColorAt(seen.at, print, shape);
#else
  area.color = vec3(0);
#endif
  return area;
}

// How much q changes over a pixel to the right and up.
vec2 changeOver(SkinArea area, Seen seen) {
  precise vec2 across = seen.across * skinCells;
  precise vec2 up = seen.up * skinCells;
  precise vec2 change = vec2(area.slope.x * across.x + area.slope.y * across.y, area.slope.x * up.x + area.slope.y * up.y);
  return change;
}

// Materials generated from a simulation field (draw/surface/skin.glsl), with texture filtering in shader code.
// SKIN_TAKEN: reads one of several skins; the including file declares the skin's parameters and the index of its first
// texel.
#include "common/once.glsl"
#include "draw/bindings.glsl"
#include "draw/surface/footprint.glsl"
#ifdef SKIN_TAKEN
#define LOOK_ANY
#else
#include "draw/surface/skin_values.glsl"
const int skinFirst_ = 0;
float skinThreshold_ = once(skinThreshold), skinRoughness_ = once(skinRoughness), skinDepth_ = once(skinDepth);
vec3 skinLow_ = once(skinLow), skinHigh_ = once(skinHigh);
#endif
#define skinThreshold skinThreshold_
#define skinRoughness skinRoughness_
#define skinDepth skinDepth_
#define skinLow skinLow_
#define skinHigh skinHigh_
#include "draw/surface/skin_look.glsl"
#ifndef SKIN_TAKEN
layout(binding = reliefUnit) uniform usamplerBuffer skinTexels;  // texels of the skin, written by skin_texels.comp
uniform ivec2 reliefSize;
ivec2 reliefSize_ = once(reliefSize);
uniform int reliefLevels;
int reliefLevels_ = once(reliefLevels);
uniform vec2 skinCells;  // size of the skin's field in cells
vec2 skinCells_ = once(skinCells);
#endif

struct SkinTexel {
  vec4 relief;
  vec4 around;  // x: mean of q in a ring around the texel; yzw: colour
};

SkinTexel skinTexel(int at) {
  uvec4 words = texelFetch(skinTexels, at + skinFirst_);
  return SkinTexel(vec4(unpackHalf2x16(words.x), unpackHalf2x16(words.y)), vec4(unpackHalf2x16(words.z), unpackHalf2x16(words.w)));
}

// Reads all values of a texel with bilinear filtering, for FILTERED of footprint.glsl. `first` is the index of the
// level's first texel.
SkinTexel skinBetween(vec2 uv, int level, int first, TextureShape shape) {
  Around around = texelsAround(uv, level, shape);
  ivec4 t = around.texels;
  int width = max(shape.size.x >> level, 1), up = first + t.y * width, down = first + t.w * width;
  SkinTexel p = skinTexel(up + t.x), q = skinTexel(up + t.z), r = skinTexel(down + t.x), s = skinTexel(down + t.z);
  precise vec4 upper = p.relief + (q.relief - p.relief) * around.part.x;
  precise vec4 lower = r.relief + (s.relief - r.relief) * around.part.x;
  precise vec4 relief = upper + (lower - upper) * around.part.y;
  precise vec4 upperRest = p.around + (q.around - p.around) * around.part.x;
  precise vec4 lowerRest = r.around + (s.around - r.around) * around.part.x;
  precise vec4 rest = upperRest + (lowerRest - upperRest) * around.part.y;
  return SkinTexel(relief, rest);
}

// Returns the index of a level's first texel.
int firstOfLevel(int level, ivec2 size) {
  int first = 0;
  for (int i = 0; i < level; ++i) {
    ivec2 across = max(size >> i, ivec2(1));
    first += across.x * across.y;
  }
  return first;
}

SkinTexel skinAt(vec2 uv, Footprint print, TextureShape shape) {
  int next = min(print.level + 1, shape.levels - 1), first = firstOfLevel(print.level, shape.size);
  ivec2 across = max(shape.size >> print.level, ivec2(1));
  int firstOfNext = next > print.level ? first + across.x * across.y : first;
  precise vec4 relief = vec4(0);
  precise vec4 around = vec4(0);
  for (int i = 0; i < print.taps; ++i) {
    precise float aside = (float(i) + 0.5f) * perTap(print.taps) - 0.5f;
    precise vec2 at = uv + print.along * aside;
    SkinTexel fine = skinBetween(at, print.level, first, shape), coarse = fine;
    if (print.part > 0.0f) coarse = skinBetween(at, next, firstOfNext, shape);
    relief = relief + (fine.relief + (coarse.relief - fine.relief) * print.part);
    around = around + (fine.around + (coarse.around - fine.around) * print.part);
  }
  precise vec4 meanRelief = relief * perTap(print.taps);
  precise vec4 meanAround = around * perTap(print.taps);
  return SkinTexel(meanRelief, meanAround);
}

SkinArea skinArea(Seen seen) {
  TextureShape shape = TextureShape(reliefSize_, reliefLevels_, ivec2(WRAP_REPEAT));
  Footprint print = footprintOf(seen, shape);
  SkinTexel found = skinAt(seen.at, print, shape);
  vec4 mean = found.relief;
  precise float spread = mean.y - mean.x * mean.x;
  precise float beyond = print.longer - 1.0f;
  // Pixels smaller than a texel have no variance, because q is only interpolated there.
  precise float variance = max(spread, 0.0f) * clamp(beyond, 0.0f, 1.0f);
  SkinArea area;
  area.q = mean.x;
  area.variance = variance;
  area.slope = mean.zw;
  area.around = found.around.x;
#if defined LOOK_MAP || defined LOOK_ANY
  area.color = found.around.yzw;
#else
  area.color = vec3(0);
#endif
  return area;
}

// Returns the change of q per pixel to the right and up.
vec2 changeOver(SkinArea area, Seen seen) {
  precise vec2 across = seen.across * skinCells_;
  precise vec2 up = seen.up * skinCells_;
  precise vec2 change = vec2(area.slope.x * across.x + area.slope.y * across.y, area.slope.x * up.x + area.slope.y * up.y);
  return change;
}

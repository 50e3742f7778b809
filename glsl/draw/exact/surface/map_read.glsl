// Material maps with texture filtering in shader code. One buffer holds the texels of all maps
// (src/draw/exact/surface/map_texels.hpp).
#ifndef EXACT_MAP_READ
#define EXACT_MAP_READ
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/surface/footprint.glsl"
layout(binding = mapTexelUnit) uniform usamplerBuffer texelsOfMaps;

// Returns the shape of a map. `map` holds the width, the height, the number of levels (with the wrap modes of u and v
// from bits 8 and 10 on), and the index of the map's level table.
TextureShape mapShape(ivec4 map) {
  return TextureShape(map.xy, map.z & 255, ivec2(map.z >> 8 & 3, map.z >> 10));
}

vec4 mapTexel(int at) {
  uvec2 words = texelFetch(texelsOfMaps, at).xy;
  precise vec4 value = vec4(words.x & 0xffffu, words.x >> 16, words.y & 0xffffu, words.y >> 16) * 1.5259022e-5f;
  return value;
}

// Reads with bilinear filtering, for FILTERED of footprint.glsl. `first` is the index of the level's first texel.
vec4 mapBetween(vec2 uv, int level, int first, TextureShape shape) {
  Around around = texelsAround(uv, level, shape);
  ivec4 t = around.texels;
  int width = max(shape.size.x >> level, 1), up = first + t.y * width, down = first + t.w * width;
  vec4 p = mapTexel(up + t.x), q = mapTexel(up + t.z), r = mapTexel(down + t.x), s = mapTexel(down + t.z);
  precise vec4 upper = p + (q - p) * around.part.x;
  precise vec4 lower = r + (s - r) * around.part.x;
  precise vec4 between = upper + (lower - upper) * around.part.y;
  return between;
}

vec4 mapWithin(vec2 uv, Footprint print, ivec4 map) {
  TextureShape shape = mapShape(map);
  int next = min(print.level + 1, shape.levels - 1);
  int first = int(texelFetch(texelsOfMaps, map.w + print.level).x), firstOfNext = int(texelFetch(texelsOfMaps, map.w + next).x);
  precise vec4 sum = vec4(0);
  for (int i = 0; i < print.taps; ++i) {
    precise float aside = (float(i) + 0.5f) * perTap(print.taps) - 0.5f;
    precise vec2 at = uv + print.along * aside;
    vec4 fine = mapBetween(at, print.level, first, shape), coarse = fine;
    if (print.part > 0.0f) coarse = mapBetween(at, next, firstOfNext, shape);
    sum = sum + (fine + (coarse - fine) * print.part);
  }
  precise vec4 mean = sum * perTap(print.taps);
  return mean;
}

vec4 mapAt(Seen seen, ivec4 map) {
  return mapWithin(seen.at, footprintOf(seen, mapShape(map)), map);
}
#endif

// Screen-space reflections of shaded points (REFLECTED). They replace part of the reflected surroundings
// (draw/surface/lighting.glsl). REFRACTED: rays through glass instead.
#if defined REFLECTED || defined REFRACTED
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/reflections/levels.glsl"
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer nearestLevels;
layout(rgba32f, binding = litImage) readonly restrict uniform imageBuffer litLevels;
#ifdef REFLECTED
#include "draw/exact/reflections/refined.glsl"
#else
const int refined_ = 0;
#endif
// Cells of level 0 are half pixels, or pixels if refined_ is 1. Then level 1 is level 0 of the mip pyramids.
float cellsPerPixel_ = refined_ != 0 ? 1.0f : 0.5f;
ivec2 halfSize = (view.size + 1) / 2, room = levelRoom(halfSize), cells_ = refined_ != 0 ? view.size : halfSize;
vec3 facing_ = vec3(0);  // normal of the shaded surface, without bump mapping
float turns_ = 0.0f;     // angle between the normals of neighbouring half pixels (radians)

float nearestAt(int level, ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), levelSize(cells_, level) - 1);
  int coarser = level - refined_;
  int place = coarser < 0 ? levelCells(room) + held.y * view.size.x + held.x : levelPlace(room, coarser, held);
  float found = imageLoad(nearestLevels, place).x;
  return held == at ? found : 0.0f;
}

vec4 litAt(int level, ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), levelSize(cells_, level) - 1);
  vec4 found = imageLoad(litLevels, levelPlace(room, max(level - refined_, 0), held));
#ifdef REFLECTED
  IF_ANY(level < refined_) found = nearestAt(0, held) > 0.0f ? imageLoad(litPixels, held) : vec4(0.0f);
#endif
  return held == at ? found : vec4(0.0f);
}
#include "draw/exact/haze.glsl"
#include "draw/exact/reflections/mirrored_way.glsl"

#ifdef REFRACTED
// Returns the light and weight of the ground at the end of the path, if the picture shows the ground there, away from objects that
// hide it.
vec4 groundMet(MirrorWay way, float ground, float roughness) {
  MirrorHit hit;
  hit.at = way.end;
  hit.counts = 1.0f;
  hit.nearest = 0.0f;
  hit.inwards = vec2(0.0f);
  hit.spread = spreadAt(way, way.end);
  precise vec2 q = way.from + way.along * way.end;
  precise float there = way.nearness + way.rate * way.end;
  precise float whole = 0.999f * ground;
  bool reaches = ground > 0.0f && metresAlong(way, way.end) >= whole && nearestAt(2, ivec2(floor(q)) >> 2) <= there;
  return reaches ? lightMirrored(way, hit, roughness) : vec4(0.0f);
}
#endif

// Returns the reflected light and its weight. `ground`: distance (m) at which the ray hits the ground, or -1 if it does
// not.
vec4 lightMet(vec3 p, vec3 direction, float ground, vec3 towards, float roughness) {
  vec4 light = vec4(0.0f);
  MirrorWay way = mirrorWay(p, direction, ground, facing_, towards, turns_, roughness);
  IF_ANY(way.counts > 0.0f) {
    light = lightAlong(way, roughness);
#ifdef REFRACTED
    IF_ANY(light.w <= 0.0f) light = groundMet(way, ground, roughness);
#endif
  }
  return light;
}
#endif

// Light that rays from shaded places bring of what the picture shows: REFLECTED, in place of a part of what is mirrored of the
// surroundings (draw/surface/lighting.glsl).
#ifdef REFLECTED
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/reflections/levels.glsl"
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer nearestLevels;
layout(rgba32f, binding = litImage) readonly restrict uniform imageBuffer litLevels;
ivec2 halfSize = (view.size + 1) / 2, room = levelRoom(halfSize);
vec3 facing_ = vec3(0);  // of the surface that is shaded, without bumps,
float turns_ = 0.0f;     // and by how much it turns from a half pixel to the next (radians)

float nearestAt(int level, ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), levelSize(halfSize, level) - 1);
  float found = imageLoad(nearestLevels, levelPlace(room, level, held)).x;
  return held == at ? found : 0.0f;
}

vec4 litAt(int level, ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), levelSize(halfSize, level) - 1);
  vec4 found = imageLoad(litLevels, levelPlace(room, level, held));
  return held == at ? found : vec4(0.0f);
}
#include "draw/exact/reflections/mirrored_way.glsl"

// `ground`: how far the ray goes until it meets that (m; -1: it does not). In loops, which end at once where there is nothing: software drivers run both sides of a branch.
vec4 lightMet(vec3 p, vec3 direction, float ground, vec3 towards, float roughness) {
  vec4 light = vec4(0.0f);
  MirrorWay way = mirrorWay(p, direction, ground, facing_, towards, turns_, roughness);
  for (int i = way.counts > 0.0f ? 0 : 1; i < 1; ++i) {
    MirrorHit hit = followMirrored(way);
    for (int j = hit.counts > 0.0f ? 0 : 1; j < 1; ++j) light = lightMirrored(way, hit, roughness);
  }
  return light;
}
#endif

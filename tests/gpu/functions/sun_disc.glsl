int scenery;

// Returns the shadow map depth of a texel. The depths form steps with holes. Some steps are at the receiver's depth.
FUNCTION float casterNear(ivec2 texel) {
  ivec2 block = (texel + 4096) >> 2;
  int drawn = someOf(64 * (block.y & 63) + (block.x & 63), scenery, 6);
  precise float near = 0.125f * float(drawn);
  return drawn == 5 ? -1e30f : near;
}

#include "draw/exact/shadows/sun_disc.glsl"

FUNCTION vec4 asked(int i) {
  scenery = i / 8;
  SunReceiver r;
  vec3 place = somePlace(i, 0);
  r.middle = vec2(32.0f, 48.0f) + 8.0f * vec2(place);
  r.near = 0.25f + 0.25f * place.z;
  r.rise = i % 3 == 0 ? vec2(0.0f) : 0.015625f * vec2(somePlace(i, 1));
  r.spread = 16.0f;
  r.minimum = i % 4 == 0 ? 0.5f : 2.0f;
  r.maximum = 12.0f;
  return vec4(sunDiscFraction(r), shadingNear(r, vec2(place.y, place.x)), 0.0f, 0.0f);
}

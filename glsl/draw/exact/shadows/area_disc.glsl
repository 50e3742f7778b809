// Fraction of a light of some size that reaches a place of one of its maps: as sun_disc.glsl has it of the sun, for nearness
// on a face (1 / distance along its axis) is as even over a plane as depth is on the sun's map.
#include "draw/exact/shadows/shadow_filter.glsl"
#include "draw/exact/shadows/disc_points.glsl"

struct AreaReceiver {
  vec2 middle;   // on the map (texels)
  float near;    // nearest caster's distance / its own
  vec2 rise;     // of `near` along the surface, for each texel across
  float spread;  // radius of the penumbra (texels) for each unit of nearness between caster and receiver
  float least;   // radius of the filter (texels) at least,
  float most;    // and at most
};

float mapNear(usamplerBuffer keys, ShadowMap map, vec2 place) {
  ivec2 at = clamp(ivec2(floor(place)), ivec2(0), ivec2(map.side - 1));
  uint key = texelFetch(keys, map.first + at.y * map.stride + at.x).x;
  return key > nearKey(0.0f) ? -1e30f : intBitsToFloat(int(nearKey(0.0f) - key));
}

// What shades among 128 places evenly over a disc: how many, and the sum of their nearness.
struct Casters {
  int count;
  float near;
};
Casters castersWithin(usamplerBuffer keys, ShadowMap map, AreaReceiver r, float radius) {
  precise vec2 aside = radius * vec2(0.033f, 0.1f);
  vec2 turned = vec2(-aside.y, aside.x);
  Casters found = Casters(0, 0.0f);
  for (int i = 0; i < 32; ++i) {
    precise vec2 middle = (0.94f * radius) * discPoints[i];
    for (int k = 0; k < 4; ++k) {  // a square of the side that the points are apart
      precise vec2 way = middle + ((k & 1) == 0 ? 1.0f : -1.0f) * ((k & 2) == 0 ? aside : turned);
      precise vec2 place = r.middle + way;
      precise float plane = r.near + r.rise.x * way.x + r.rise.y * way.y;
      float near = mapNear(keys, map, place);
      bool shades = near > plane;
      precise float sum = found.near + (shades ? near : 0.0f);
      found.near = sum;
      found.count += shades ? 1 : 0;
    }
  }
  return found;
}

float areaDiscFraction(usamplerBuffer keys, ShadowMap map, AreaReceiver r) {
  precise float widest = (1.0f - r.near) * r.spread;
  Casters casters = castersWithin(keys, map, r, clamp(widest, r.least, r.most));
  if (casters.count == 0) return 1.0f;
  precise float between = casters.near * exactReciprocal(float(casters.count)) - r.near;
  precise float wide = between * r.spread;
  int shaded = castersWithin(keys, map, r, clamp(wide, r.least, r.most)).count;
  precise float fraction = float(128 - shaded) * 0.0078125f;
  return fraction;
}

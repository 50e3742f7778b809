// Fraction of a sun of some angular size that reaches a place of its map: first how far away what shades the place is, on
// the average, then the map filtered over the penumbra that this gives, which is as wide as that way times the sun's
// angular size (Fernando 2005, "Percentage-closer soft shadows"). Whoever includes it has float casterNear(ivec2 texel):
// 1 - depth of what is there, less than any where nothing is; and the points of disc_points.glsl. Compiles as GLSL and as C++.
#ifndef EXACT_SUN_DISC
#define EXACT_SUN_DISC
#include "common/exact.glsl"

const int discTaps = 32;  // of discPoints, which come with casterNear

struct SunReceiver {
  vec2 middle;   // on the map (texels)
  float near;    // 1 - depth; less than 0 behind every caster
  vec2 rise;     // of `near` along the surface, for each texel across: what lies in its plane does not shade it
  float spread;  // radius of the penumbra (texels) for each unit of depth between caster and receiver
  float least;   // radius of the filter (texels) at least,
  float most;    // and at most
};

// Nearness of the receiver's plane a way (texels) across.
FUNCTION float planeNear(SunReceiver r, vec2 way) {
  precise float near = r.near + r.rise.x * way.x + r.rise.y * way.y;
  return near;
}

FUNCTION bool isShaded(SunReceiver r, vec2 way) {
  precise vec2 place = r.middle + way;
  return casterNear(ivec2(floor(place))) > planeNear(r, way);
}

// Of the four points of a square around a place a way across, those that are lit. `aside`: of the first from there.
FUNCTION int litOfFour(SunReceiver r, vec2 way, vec2 aside) {
  precise vec2 turned = vec2(-aside.y, aside.x);
  precise vec2 one = way + aside;
  precise vec2 two = way - aside;
  precise vec2 three = way + turned;
  precise vec2 four = way - turned;
  return (isShaded(r, one) ? 0 : 1) + (isShaded(r, two) ? 0 : 1) + (isShaded(r, three) ? 0 : 1) +
         (isShaded(r, four) ? 0 : 1);
}

FUNCTION float sunDiscFraction(SunReceiver r) {
  // Casters have nearness 1 at most.
  precise float widest = (1.0f - r.near) * r.spread;
  float search = clamp(widest, r.least, r.most);
  int casters = 0;
  precise float sum = 0.0f;
  for (int i = 0; i < discTaps; ++i) {
    precise vec2 way = search * discPoints[i];
    precise vec2 place = r.middle + way;
    float near = casterNear(ivec2(floor(place)));
    bool shades = near > planeNear(r, way);
    sum = sum + (shades ? near : 0.0f);
    casters += shades ? 1 : 0;
  }
  if (casters == 0) return 1.0f;
  if (casters == discTaps) return 0.0f;
  precise float between = sum * exactReciprocal(float(casters)) - r.near;
  precise float wide = between * r.spread;
  float radius = clamp(wide, r.least, r.most);
  // Squares of a side that the points are apart, so that all of theirs are evenly over the disc.
  precise vec2 aside = radius * vec2(0.033f, 0.1f);
  int lit = 0;
  for (int i = 0; i < discTaps; ++i) {
    precise vec2 way = (0.94f * radius) * discPoints[i];
    lit += litOfFour(r, way, aside);
  }
  precise float fraction = float(lit) * 0.0078125f;
  return fraction;
}
#endif
